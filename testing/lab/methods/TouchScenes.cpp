// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/lab/methods/TouchScenes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "testing/support/Corners.h"
#include "testing/support/Meshes.h"
#include "testing/support/QpOracle.h"

namespace palpate::lab
{
namespace
{

const std::string penalty = "penalty", halfSpaces = "half-spaces", oneConstraint = "one-constraint",
                  alternating = "alternating", pointWithoutSide = "point-no-side", textbookLoop = "textbook-loop";
/// The same loop fails where it does.
const std::string onEmbree = "textbook-loop on Embree";
/// Sweeps go to one plane after the other, as "alternating" does.
const std::string sweeps = "Bullet's sweeps r=1mm";
/// Late in every scene: contact begins between two of its frames.
const std::string held = "held-60Hz";

constexpr double mm = 1e-3;

/// 0, 1, ... steps, ..., 1, 0, 1, ... by tick.
int backAndForth(int tick, int steps)
{
  return steps - std::abs(tick % (2 * steps) - steps);
}

/// Straight down at 0.1 m/s from 5.05 mm to `depth_m` below, then along at 0.05 m/s. Shallowest contact: 0.05 mm.
Vec3 downAndAlong(int tick, double depth_m)
{
  const double height_m = std::max(5.05 * mm - 0.1 * mm * tick, -depth_m);
  const int slid = backAndForth(std::max(0, tick - 80), 600);
  return { -15 * mm + 0.05 * mm * slid, 3 * mm + 0.01 * mm * slid, height_m };
}

Vec3 aboveThePlane(const Vec3& p_W, double r_u)
{
  return { 0, 0, std::max(0.0, r_u - p_W.z()) };
}

TouchScene plane(const std::string& name, const TriangleMesh& mesh, double metre_u, std::vector<std::string> failing)
{
  return { name, mesh, metre_u, 2 * mm * metre_u,
    [metre_u](int tick, double r_u) { return Vec3(metre_u * downAndAlong(tick, 2 * mm) + r_u * Vec3::UnitZ()); },
    aboveThePlane, std::move(failing) };
}

TouchScene thinPlate()
{
  const auto device = [](int tick, double r_u)
  { return Vec3(0.002 * mm * backAndForth(tick, 2000), 4 * mm, r_u + 5.05 * mm - 0.1 * mm * backAndForth(tick, 100)); };
  return { "thin-plate", test::makeBox({ -0.05, -0.05, -0.5 * mm }, { 0.05, 0.05, 0 }), 1.0, 5 * mm, device,
    aboveThePlane, { penalty, held } };
}

/// The force of a box whose top is z = 0 and whose edge is x = z = 0, on a ball that came from above: the top's while
/// the device is before the edge, past it the round edge's or the side's.
Vec3 overTheEdge(const Vec3& p_W, double r_u)
{
  if (p_W.x() < 0)
  {
    return aboveThePlane(p_W, r_u);
  }
  const Vec3 away(p_W.x(), 0, std::max(0.0, p_W.z()));
  return std::max(0.0, r_u - away.norm()) * away.normalized();
}

/// Down before the edge, 1 mm deep at 0.1 m/s across it, up behind it and back: a lap of 200 ticks.
TouchScene convexEdge()
{
  const auto device = [](int tick, double)
  {
    const int at = tick % 200;
    const int down = std::clamp(at, 0, 40) - std::clamp(at - 100, 0, 40);
    const int across = std::clamp(at - 40, 0, 60) - std::clamp(at - 140, 0, 60);
    return Vec3(-2.98 * mm + 0.1 * mm * across, 10 * mm, 3 * mm - 0.1 * mm * down);
  };
  return { "convex-edge", test::makeBox({ -0.1, -0.05, -0.1 }, { 0, 0.05, 0 }), 1.0, 1 * mm, device, overTheEdge,
    { penalty, halfSpaces, oneConstraint, alternating, pointWithoutSide, textbookLoop, onEmbree, sweeps, held } };
}

/// The force in the free cone n . x >= r of at most three planes through the origin, in rational arithmetic.
std::function<Vec3(const Vec3&, double)> forceInCone(const std::vector<Vec3>& normals)
{
  return [normals](const Vec3& p_W, double r_u)
  {
    std::vector<PlaneRow> rows;
    for (const Vec3& n : normals)
    {
      rows.push_back({ n, r_u });
    }
    return Vec3(test::projectExactly(rows, p_W).y - p_W);
  };
}

/// From the free side to the device point of the corner in ten ticks, 30 there with a drift, and back. `apex` is where
/// the planes meet for a ball of radius 1.
TouchScene corner(const std::string& name, const test::Corner& shape, const Vec3& apex, test::Random& random,
  std::vector<std::string> failing)
{
  const auto device = [shape, apex](int tick, double r_u)
  {
    const int at = tick % 50;
    const int in = std::clamp(at, 0, 10) - std::clamp(at - 40, 0, 10);
    const Vec3 drift_W(0, 0.02 * mm * backAndForth(at - std::min(at, 10), 20), 0);
    return Vec3(shape.start_W() + 0.1 * in * (shape.p_W + drift_W - shape.start_W()) + r_u * apex);
  };
  return { name, test::meshOf(shape, random), 1.0, shape.p_W.norm(), device, forceInCone(shape.normals),
    std::move(failing) };
}

TouchScene groove()
{
  const double slope = std::numbers::sqrt2 / 2;
  const auto device = [](int tick, double r_u)
  {
    const double sway_m = 0.05 * mm * (backAndForth(std::max(0, tick - 80) + 40, 80) - 40);
    const Vec3 down = downAndAlong(tick, 2 * mm);
    return Vec3(0.31 * mm + sway_m, down.x(), down.z() + r_u * std::numbers::sqrt2);
  };
  return { "groove", test::makeGroove(std::numbers::pi / 4, 0.05), 1.0, 2 * mm, device,
    forceInCone({ { slope, 0, slope }, { -slope, 0, slope } }), { penalty, oneConstraint, pointWithoutSide, held } };
}

/// Tapped at 2 m/s and stroked along a great circle 1 mm deep; at less depth the facets themselves are felt. Every edge
/// of it is convex.
TouchScene sphere(test::Random& random)
{
  constexpr double radius_m = 0.05;
  const Vec3 through = random.direction(), along = through.unitOrthogonal();
  const auto device = [through, along](int tick, double r_u)
  {
    const double height_m = std::max(5 * mm - 2 * mm * tick, -1 * mm), a = 5e-4 * std::max(0, tick - 20);
    return Vec3((radius_m + r_u + height_m) * (std::cos(a) * through + std::sin(a) * along));
  };
  const auto force = [](const Vec3& p_W, double r_u)
  { return Vec3(std::max(0.0, radius_m + r_u - p_W.norm()) * p_W.normalized()); };
  return { "sphere-20k", test::makeIcosphere(5, radius_m), 1.0, 1 * mm, device, force,
    { halfSpaces, textbookLoop, onEmbree, held } };
}

/// Thrown at the back of a sheet at 10 m/s, kept behind it for 25 ticks, let go for 25.
TouchScene fastSheet(test::Random& random)
{
  const auto device = [](int tick, double r_u)
  {
    const double height_m = std::clamp(10 * mm * (tick % 50) - 15 * mm, -15 * mm, 5 * mm);
    return Vec3(0.1 * mm * (tick % 50), 3 * mm, tick % 50 < 27 ? height_m - r_u : -15 * mm - r_u);
  };
  const auto force = [](const Vec3& p_W, double r_u) { return Vec3(0, 0, -std::max(0.0, p_W.z() + r_u)); };
  return { "sheet-fast", test::makeSheet({ 0.1, 0.1, 40, 40, 0.3 }, random), 1.0, 5 * mm, device, force,
    { penalty, held } };
}

} // namespace

bool TouchScene::fails(const std::string& method) const
{
  return std::find(this->failing.begin(), this->failing.end(), method) != this->failing.end();
}

std::vector<TouchScene> touchScenes(test::Random& random)
{
  const TriangleMesh flat = test::makeSheet({ 0.1, 0.1, 40, 40, 0.3 }, random);
  const std::vector<test::Corner> corners = test::corners();
  const Vec3 cubeApex(1, 1, 1), wedgeApex(2 + std::sqrt(3.0), 0, 1);
  return {
    plane("plane", flat, 1.0, { held }),
    thinPlate(),
    convexEdge(),
    corner("corner", corners[2], cubeApex, random, { penalty, oneConstraint, pointWithoutSide, held }),
    corner("wedge-30", corners[3], wedgeApex, random,
      { penalty, oneConstraint, alternating, pointWithoutSide, sweeps, held }),
    sphere(random),
    groove(),
    fastSheet(random),
    plane("soup", test::withDefects(flat, random), 1.0, { penalty, held }),
    plane("micro", test::scaled(flat, 1e-6), 1e-6,
      { halfSpaces, oneConstraint, alternating, pointWithoutSide, textbookLoop, onEmbree, held }),
  };
}

} // namespace palpate::lab
