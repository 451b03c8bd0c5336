// SPDX-License-Identifier: GPL-3.0-or-later
// Row 14: the inner edges of a tessellated plane cannot be felt.
#include <algorithm>
#include <cmath>
#include <string>

#include "haptics/core/PoseMath.h"
#include "testing/lab/Experiments.h"
#include "testing/lab/methods/ContactMethod.h"
#include "testing/lab/methods/Textbook.h"
#include "testing/support/Meshes.h"

namespace palpate::lab
{
namespace tessellated_plane_experiment
{

constexpr double stiffness_N_per_m = 1000.0, depth_m = 2e-3;

struct Slide
{
  double lateral_N = 0.0; ///< largest force along the plane
  double ripple_N = 0.0;  ///< largest |F_n - K p|
  Cost cost;
};

/// 1 m along and 0.1 m across the plane whose normal is q * z, 2 mm deep.
Slide slide(const World& world, const Quat& q, const MethodKind& kind, int ticks)
{
  const auto proxy = kind.make(world);
  proxy->start(q * Vec3(-0.5, -0.05, 0.01));
  test::CostSample sample(static_cast<std::size_t>(ticks) + 1);
  Slide seen;
  for (int i = 0; i <= ticks; ++i)
  {
    const double s = static_cast<double>(i) / ticks;
    MethodTick tick;
    sample.time([&] { tick = proxy->tick(q * Vec3(-0.5 + s, -0.05 + 0.1 * s, kind.radius_m - depth_m)); });
    const Vec3 force_N = q.conjugate() * (stiffness_N_per_m * tick.force_u);
    seen.lateral_N = std::max(seen.lateral_N, force_N.head<2>().norm());
    seen.ripple_N = std::max(seen.ripple_N, std::abs(force_N.z() - stiffness_N_per_m * depth_m));
  }
  seen.cost = Cost::of(sample);
  return seen;
}

} // namespace tessellated_plane_experiment

void runTessellatedPlane(const Conditions& conditions, Table& table)
{
  using namespace tessellated_plane_experiment;
  test::Random random(conditions.seed + 81);
  const TriangleMesh flat = test::makeSheet({ 1.2, 1.2, 200, 200, 0.35 }, random);
  const int ticks = conditions.pick(2000, 10000, 100000);
  for (const auto& [name, normal] : { std::pair<std::string, Vec3>{ "plane=level", Vec3::UnitZ() },
         std::pair<std::string, Vec3>{ "plane=tilted", Vec3(0.3, -0.5, 0.8).normalized() } })
  {
    const Quat q = shortestTurn(Vec3::UnitZ(), normal);
    const World world(test::rotated(flat, q));
    for (const std::string ours : { "god-object r=0", "god-object r=1mm" })
    {
      const Slide seen = slide(world, q, method(ours), ticks);
      table.atMost({ name, ours, "lateral force", "N" }, seen.lateral_N, 1e-9).cost = seen.cost;
      table.atMost({ name, ours, "ripple of the normal force", "N" }, seen.ripple_N, 1e-9);
    }
    // A constant gap is felt as K times the gap.
    const double gap_N = stiffness_N_per_m * gap_u;
    table.within({ name, "textbook-loop", "ripple of the normal force", "N" },
      slide(world, q, method("textbook-loop"), ticks).ripple_N, gap_N, 1e-3 * gap_N);
  }
}

} // namespace palpate::lab
