// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/RadiusLimit.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <sstream>

#include "haptics/contact/sweep/DiscFilter.h"
#include "haptics/contact/sweep/TreeWalk.h"
#include "haptics/contact/sweep/Work.h"
#include "haptics/contact/view/SceneView.h"

namespace palpate
{
namespace
{

/// Triangles on which a ball is laid, of one surface and of all. With hundreds of surfaces each is looked at in few
/// places, so that the count takes no longer than for 64 of them.
constexpr std::size_t placesPerSurface = 256, placesOfAll = 16384, leastPlaces = 8;
/// In radii: the first part of a long way (TickState.h: firstPart) is looked at alone, and goes so far beyond a ball at
/// rest.
constexpr double reach = 1.02;
/// Radii tried, in scene sizes: beyond the largest a ball is flat, below the smallest it is a point.
constexpr double flat = 64.0, pointlike = 1e-9;
/// Of ln(flat / pointlike), which is 25: they tell the radius to 2e-11 of itself.
constexpr int halvings = 40;

/// Where a ball rests on a surface.
struct Place
{
  Vec3 p_W, normal_W;
};

/// How many faces of a leaf a sweep tests.
std::uint32_t reachedIn(const SurfaceData& data, std::uint32_t index, const SweptBall& m)
{
  const Leaf& leaf = data.leaves[index];
  const DiscFilter filter(m, leaf.origin_W, leaf.perUnit);
  const int lanes = filter.touched(data.discs[2 * index]) | filter.touched(data.discs[2 * index + 1]) << 4;
  return static_cast<std::uint32_t>(std::popcount(static_cast<unsigned>(lanes & ((1 << leaf.count) - 1))));
}

class Reachable
{
public:
  Reachable(const Scene& scene, std::uint32_t most) : scene_(scene, 1.0), most_(most) {}

  /// True if a sweep of a ball of this radius that rests here takes more work than a sweep may.
  [[nodiscard]] bool tooMuch(const Place& place, double radius_u) const
  {
    const Scene& scene = this->scene_.scene();
    SweepQuery query;
    query.from_W = query.to_W = place.p_W + radius_u * place.normal_W;
    query.radius_u = reach * radius_u;
    query.resolution.include(query.from_W);
    const SweptBall still = sweptBallOf(query);
    std::uint32_t done = 0;
    const auto visit = [&](std::uint32_t s) noexcept
    {
      const auto surface = surfaceOf(this->scene_, s);
      return askTree(surface, still,
        [&](const SweptBall& inSurface) noexcept
        {
          const auto test = [&](std::uint32_t leaf) noexcept
          {
            done += work::faceTest * reachedIn(surface.data(), leaf, inSurface);
            return true;
          };
          return walkWithin(surface.data().nodes, BoxTest(inSurface), this->most_, done, test);
        });
    };
    return !walkWithin(scene.surfaceTree().nodes, BoxTest(still), this->most_, done, visit);
  }

  /// The largest radius up to `limit_u` that is not too much here; 0 where even the least is.
  [[nodiscard]] double largest_u(const Place& place, double limit_u, double least_u) const
  {
    if (!this->tooMuch(place, limit_u))
    {
      return limit_u;
    }
    if (this->tooMuch(place, least_u))
    {
      return 0.0;
    }
    // A larger ball that rests in the same place holds all of the smaller one: a radius that is too large for it stays
    // too large.
    double low = std::log(least_u), high = std::log(limit_u);
    for (int i = 0; i < halvings && low < high; ++i)
    {
      const double middle = 0.5 * (low + high);
      (this->tooMuch(place, std::exp(middle)) ? high : low) = middle;
    }
    return std::exp(low);
  }

private:
  MovingScene scene_;
  std::uint32_t most_;
};

Place placeOn(const PosedSurface& surface, std::uint32_t triangle, double side)
{
  const FaceRecord face = surface.face(triangle);
  const Vec3 normal_W =
    isSegment(surface.corners(triangle)) ? (face.corner_W[1] - face.corner_W[0]).unitOrthogonal() : face.normal_W;
  return { (face.corner_W[0] + face.corner_W[1] + face.corner_W[2]) / 3.0, side * normal_W };
}

} // namespace

RadiusLimit radiusLimit(const Scene& scene, const ContactPlan& plan)
{
  RadiusLimit limit;
  limit.asked_u = plan.radius_u;
  limit.largest_u = std::numeric_limits<double>::infinity();
  if (scene.empty())
  {
    return limit;
  }
  const Box& bounds = scene.surfaceTree().bounds;
  const double size_u = (bounds.high_W - bounds.low_W).norm();
  const std::uint64_t sweeps =
    static_cast<std::uint64_t>(RadiusLimit::sweepsPerPass) * std::max(plan.passCap, std::uint32_t{ 1 });
  const Reachable reachable(scene, static_cast<std::uint32_t>(plan.workBudget / sweeps));
  const double most_u = flat * size_u, least_u = pointlike * size_u;
  double largest_u = most_u;
  for (std::uint32_t s = 0; s < scene.surfaces().size(); ++s)
  {
    const PosedSurface surface = surfaceOf(MovingScene(scene, 1.0), s);
    const std::size_t count = surface.data().faces.size();
    const std::size_t share = std::clamp(placesOfAll / scene.surfaces().size(), leastPlaces, placesPerSurface);
    const std::size_t places = std::min(count, share);
    for (std::size_t i = 0; i < 2 * places && largest_u > 0.0; ++i)
    {
      // The triangles stand in the order of the leaves: taken evenly, they are dense where the surface is fine.
      const auto triangle = static_cast<std::uint32_t>((i / 2) * count / places);
      const Place place = placeOn(surface, triangle, i % 2 == 0 ? 1.0 : -1.0);
      largest_u = reachable.largest_u(place, largest_u, least_u);
    }
  }
  limit.largest_u = largest_u < most_u ? largest_u : limit.largest_u;
  return limit;
}

std::string RadiusLimit::sentence() const
{
  std::ostringstream text;
  text.precision(3);
  if (std::isinf(this->largest_u))
  {
    text << "a ball of any size finishes its work in a tick";
    return text.str();
  }
  text << "a ball of radius " << this->asked_u << " scene units ";
  if (this->kept())
  {
    text << "finishes its work in a tick, up to " << this->largest_u << " would";
  }
  else
  {
    text << "is large for triangles so fine: above " << this->largest_u
         << " it may run out of a tick's work and then moves only as far as is proven free";
  }
  return text.str();
}

} // namespace palpate
