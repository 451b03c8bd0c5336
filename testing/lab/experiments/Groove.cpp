// SPDX-License-Identifier: GPL-3.0-or-later
// Rows 19 and 20: a ball in a groove, a ball over an edge.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "testing/lab/Experiments.h"
#include "testing/support/Meshes.h"
#include "testing/support/Probe.h"

namespace palpate::lab
{
namespace groove_experiment
{

constexpr double r = 1e-3, edge_m = 0.05, radians = std::numbers::pi / 180;
const char* const ours = "god-object r=1mm";

void runGrooves(Table& table)
{
  for (const int degrees : { 5, 15, 30, 45, 60, 80, 89 })
  {
    const double angle = degrees * radians;
    const std::string caseName = "half-angle=" + std::to_string(degrees) + "deg";
    const TriangleMesh mesh = test::makeGroove(angle, 0.05);
    test::PathChecker checker(mesh, r, 1e-15);
    test::Probe ball(test::sceneOf(mesh), r, { 0.0, 0.001, 0.04 }, &checker);
    ball.to({ 1e-4, 0.002, -0.005 });
    // At distance r from both walls, which meet in the y axis: height r / sin(half angle).
    table.within({ caseName, ours, "height of the centre", "m" }, ball.x_W().z(), r / std::sin(angle), 1e-12);
    table.atMost({ caseName, ours, "distance from the middle", "m" }, std::abs(ball.x_W().x()), 1e-12);
    table.within({ caseName, ours, "paths that come nearer than the radius", "" }, !ball.finding().empty(), 0.0, 0.0);
    test::Probe point(test::sceneOf(mesh), 0.0, { 0.0, 0.001, 0.04 });
    point.to({ 0.0, 0.002, -0.005 });
    table.within({ caseName, "god-object r=0", "height of the centre", "m" }, point.x_W().z(), 0.0, 1e-12);
  }
}

struct Roll
{
  double deviation_m = 0.0;
  int passes = 0;
};

/// The device goes round the edge at `fraction` of the radius: the centre must be straight outwards of it at r.
Roll roll(double fraction, int steps)
{
  test::Probe ball(
    test::sceneOf(test::makeBox({ -edge_m, -edge_m, -0.1 }, { edge_m, edge_m, 0 })), r, { edge_m - 0.01, 0.01, 2 * r });
  ball.along({ edge_m, 0.01, fraction * r }, 20);
  Roll seen;
  for (int i = 0; i <= steps; ++i)
  {
    const double a = 90.0 * radians * i / steps;
    const Vec3 outwards(std::sin(a), 0, std::cos(a)), middle(edge_m, 0.01, 0);
    seen.passes = std::max(seen.passes, ball.to(middle + fraction * r * outwards).passes);
    seen.deviation_m = std::max(seen.deviation_m, (ball.x_W() - middle - r * outwards).norm());
  }
  return seen;
}

/// The same with the two planes shifted by r and nothing between them: out of the nearer one.
double polygonalDeviation(double fraction, int steps)
{
  double largest_m = 0.0;
  for (int i = 0; i <= steps; ++i)
  {
    const double a = 90.0 * radians * i / steps, x = fraction * r * std::sin(a), z = fraction * r * std::cos(a);
    largest_m = std::max(largest_m, (x > z ? std::hypot(r, z) : std::hypot(x, r)) - r);
  }
  return largest_m;
}

} // namespace groove_experiment

void runGroove(const Conditions& conditions, Table& table)
{
  using namespace groove_experiment;
  runGrooves(table);
  const int steps = 2 * conditions.pick(45, 450, 4500);
  for (const double fraction : { 0.99, 0.5, 0.1 })
  {
    const std::string caseName = "edge=90deg device=" + std::to_string(fraction).substr(0, 4) + "r";
    const Roll seen = roll(fraction, steps);
    table.atMost({ caseName, ours, "deviation from the arc", "m" }, seen.deviation_m, 1e-6);
    table.atMost({ caseName, ours, "passes", "" }, seen.passes, 4.0);
    // Worst on the bisector, where the device is fraction r / sqrt(2) from either side.
    table.within({ caseName, "offset-planes", "deviation from the arc", "m" }, polygonalDeviation(fraction, steps),
      r * (std::sqrt(1 + fraction * fraction / 2) - 1), 1e-12);
  }
}

} // namespace palpate::lab
