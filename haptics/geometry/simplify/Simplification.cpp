// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/simplify/Simplification.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "haptics/geometry/simplify/EdgeCollapse.h"
#include "haptics/geometry/simplify/SheetClearance.h"
#include "haptics/geometry/simplify/SurfaceDistance.h"
#include "haptics/geometry/simplify/SurfacePatches.h"

namespace palpate
{
namespace
{

Simplification refusedBecause(std::string reason)
{
  return { nullptr, 0.0, std::move(reason) };
}

/// Which triangles of the simpler surface are the first one's as they were.
std::vector<bool> unchangedTriangles(const SurfaceTree& surface, const SurfaceTree& fewer)
{
  using Key = std::array<std::array<double, 3>, 3>;
  const auto keyOf = [](const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& corners)
  {
    Key key;
    std::transform(corners.begin(), corners.end(), key.begin(),
      [&mesh](std::uint32_t v)
      {
        const Vec3& p_W = mesh.vertices_W[v];
        return std::array{ p_W.x(), p_W.y(), p_W.z() };
      });
    std::sort(key.begin(), key.end());
    return key;
  };
  std::vector<Key> before;
  for (const auto& corners : surface.mesh().triangles)
  {
    before.push_back(keyOf(surface.mesh(), corners));
  }
  std::sort(before.begin(), before.end());
  std::vector<bool> unchanged;
  for (const auto& corners : fewer.mesh().triangles)
  {
    unchanged.push_back(std::binary_search(before.begin(), before.end(), keyOf(fewer.mesh(), corners)));
  }
  return unchanged;
}

/// Both ways within the limit, and nothing crosses that did not before.
Simplification prove(const SurfaceTree& surface, std::shared_ptr<const SurfaceTree> fewer, const SimplifyLimits& limits)
{
  const DistanceProof there = proveWithin(surface, *fewer, limits.limit_u, limits.stop);
  const DistanceProof back = there.verdict == DistanceProof::Verdict::Within
                               ? proveWithin(*fewer, surface, limits.limit_u, limits.stop)
                               : DistanceProof{};
  if (back.verdict != DistanceProof::Verdict::Within)
  {
    return refusedBecause("the distance of the simplified surface could not be proven to be small enough");
  }
  if (crossingTriangles(*fewer, limits.stop) &&
      crossingTriangles(*fewer, unchangedTriangles(surface, *fewer), limits.stop))
  {
    return refusedBecause("the simplified surface would intersect itself");
  }
  return { std::move(fewer), std::max(there.bound_u, back.bound_u), {} };
}

/// The result of one try.
struct Attempt
{
  Simplification result;
  bool lessMayDo = false; ///< refused for a change of the surface, not for too many triangles
};

/// Shares of a limit that are used while edges collapse. Places between the samples may get further; if one gets too
/// far, a smaller share is tried.
constexpr std::array<double, 3> shares = { 0.75, 0.4, 0.25 };

SimplifyLimits shareOf(const SimplifyLimits& limits, double share)
{
  return { share * limits.limit_u, limits.stop, limits.progress };
}

Attempt attempt(const SurfaceTree& surface, const std::vector<bool>& fixed, double share, const SimplifyLimits& limits)
{
  const std::optional<CollapsedMesh> fewer = collapseEdges(surface.mesh(), fixed, shareOf(limits, share));
  if (!fewer)
  {
    return { refusedBecause("its triangles do not form a surface whose edges can be collapsed") };
  }
  CleanResult clean = cleanMesh(fewer->mesh);
  if (!clean.ok() || clean.report.collinear > 0)
  {
    return { refusedBecause("no triangle would remain"), true };
  }
  if (2 * clean.mesh.triangles.size() > surface.mesh().triangles.size())
  {
    return { refusedBecause("fewer than half of its triangles could be removed without a perceptible change") };
  }
  return { prove(surface, std::make_shared<const SurfaceTree>(std::move(clean.mesh)), limits), true };
}

/// Parts of a surface, on which a share of the limit is tried before it is tried on all.
class Sample
{
public:
  enum class Verdict
  {
    Promising,
    KeepsTooMuch, ///< far more than half; a smaller share keeps more
    Unproven,     ///< and so will be the whole surface
  };

  Sample(const SurfaceTree& surface, const SimplifyLimits& limits)
    : limits_{ limits.limit_u, limits.stop, {} }, patches_(patchesOf(surface, count, size))
  {
    const std::vector<bool> near =
      verticesNearOtherSheets(surface, 2 * limits.limit_u, this->patches_.triangles, limits.stop);
    this->fixed_ = this->patches_.rim;
    for (std::size_t v = 0; v < this->fixed_.size(); ++v)
    {
      this->fixed_[v] = this->fixed_[v] || near[this->patches_.vertices[v]];
    }
  }

  [[nodiscard]] static bool pays(const SurfaceTree& surface)
  {
    return surface.mesh().triangles.size() >= 4 * count * size;
  }

  [[nodiscard]] Verdict judge(double share) const
  {
    const std::optional<CollapsedMesh> fewer =
      collapseEdges(this->patches_.mesh, this->fixed_, shareOf(this->limits_, share));
    if (!fewer)
    {
      return Verdict::Promising; // the whole surface says why not
    }
    // Those that have all of their triangles in a part stand for the surface.
    const auto inner = static_cast<double>(std::count(this->patches_.rim.begin(), this->patches_.rim.end(), false));
    if (static_cast<double>(fewer->verticesGone) < (1.0 - mostThatStays) * inner)
    {
      return Verdict::KeepsTooMuch;
    }
    return this->proven(fewer->mesh) ? Verdict::Promising : Verdict::Unproven;
  }

private:
  static constexpr std::size_t count = 16, size = 512;
  static constexpr double mostThatStays = 0.6; // half, and the error of a sample
  static constexpr double ofLimit = 0.8;       // the worst place of all is worse than that of a sample

  [[nodiscard]] bool proven(const TriangleMesh& simpler) const
  {
    CleanResult full = cleanMesh(this->patches_.mesh), fewer = cleanMesh(simpler);
    if (!full.ok() || !fewer.ok())
    {
      return false;
    }
    const SurfaceTree from(std::move(full.mesh)), to(std::move(fewer.mesh));
    const auto within = [this](const SurfaceTree& a, const SurfaceTree& b)
    {
      return proveWithin(a, b, ofLimit * this->limits_.limit_u, this->limits_.stop).verdict ==
             DistanceProof::Verdict::Within;
    };
    return within(from, to) && within(to, from);
  }

  SimplifyLimits limits_;
  SurfacePatches patches_;
  std::vector<bool> fixed_;
};

/// The distance within which the search for other sheets is affordable: its work grows with the square of the distance.
double affordable_u(const SurfaceTree& surface, double limit_u)
{
  constexpr std::size_t samples = 64;
  constexpr double mostLookedAt = 256.0;
  const double lookedAt = trianglesWithin(surface, 2 * limit_u, samples);
  return limit_u * std::sqrt(std::min(1.0, mostLookedAt / lookedAt));
}

/// All corners of triangles at edges of three or more: nothing there changes.
void fixCrowded(const SurfaceData& data, std::vector<bool>& fixed)
{
  for (const auto& corners : data.mesh.triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::uint32_t i = corners[k], j = corners[(k + 1) % 3];
      int around = 0;
      data.forEachAtEdge(i, j, [&around](std::uint32_t) { ++around; });
      if (around > 2)
      {
        data.forEachAtEdge(i, j,
          [&](std::uint32_t t)
          {
            for (const std::uint32_t v : data.corners(t))
            {
              fixed[v] = true;
            }
          });
      }
    }
  }
}

std::vector<bool> whatStays(const SurfaceTree& surface, const SimplifyLimits& limits)
{
  std::vector<bool> fixed = verticesNearOtherSheets(surface, 2 * limits.limit_u, limits.stop);
  fixCrowded(surface.data(), fixed);
  return fixed;
}

/// Where a sample can be tried first, all of it is tried once: the sample has chosen the share.
Simplification search(const SurfaceTree& surface, const SimplifyLimits& limits)
{
  const std::optional<Sample> sample =
    Sample::pays(surface) ? std::optional<Sample>(std::in_place, surface, limits) : std::nullopt;
  const std::size_t mostAttempts = sample ? 1 : shares.size();
  std::vector<bool> fixed;
  std::size_t attempts = 0;
  Simplification last = refusedBecause("in a sample no simpler surface could be proven to be near enough");
  for (const double share : shares)
  {
    const Sample::Verdict verdict = sample ? sample->judge(share) : Sample::Verdict::Promising;
    if (verdict == Sample::Verdict::KeepsTooMuch)
    {
      return refusedBecause(
        "in a sample fewer than half of the triangles could be removed without a perceptible change");
    }
    if (verdict == Sample::Verdict::Unproven)
    {
      continue;
    }
    fixed = fixed.empty() ? whatStays(surface, limits) : std::move(fixed);
    Attempt tried = attempt(surface, fixed, share, limits);
    last = std::move(tried.result);
    if (last.tree || !tried.lessMayDo || ++attempts == mostAttempts || limits.stop.stop_requested())
    {
      break;
    }
  }
  return last;
}

} // namespace

Simplification simplifyWithin(const SurfaceTree& surface, const SimplifyLimits& limits)
{
  if (!(limits.limit_u > 0.0) || !std::isfinite(limits.limit_u))
  {
    return refusedBecause("the tolerance of the simplification must be above 0");
  }
  if (surface.coat_u() > 0.0)
  {
    return refusedBecause("curves are not simplified");
  }
  SimplifyLimits afforded = limits;
  afforded.limit_u = affordable_u(surface, limits.limit_u);
  const Simplification result = search(surface, afforded);
  return limits.stop.stop_requested() ? refusedBecause("the simplification was stopped") : result;
}

} // namespace palpate
