// SPDX-License-Identifier: GPL-3.0-or-later
// Row 18: the direction of the force on a faceted sphere with and without force shading, its cost, and the work that a
// shaded force, which has no potential, does over a closed path.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "testing/lab/Experiments.h"
#include "testing/support/Facets.h"
#include "testing/support/Meshes.h"
#include "testing/support/Probe.h"

namespace palpate::lab
{
namespace force_shading_experiment
{

constexpr double sphere_mm = 50.0, degree = std::numbers::pi / 180.0;

struct Loop
{
  double off_deg = 0.0;  ///< largest angle between force and radius
  double jump_deg = 0.0; ///< largest turn of the force in a tick beyond that of the radius
  double work_mJ = 0.0;  ///< on the hand over the closed path, at 1 N/mm
  Cost cost;
};

double angle_deg(const Vec3& a, const Vec3& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b)) / degree;
}

/// Once round a great circle through the middle of the worst face, `depth_mm` below the true sphere.
Loop rub(const std::shared_ptr<const Scene>& scene, const Vec3& through, bool shading, double ball_mm, double depth_mm,
  int ticks)
{
  const Vec3 along = through.unitOrthogonal();
  const double distance_mm = sphere_mm + ball_mm - depth_mm;
  test::Probe probe(scene, ball_mm, 1.3 * distance_mm * through);
  probe.plan().shading = shading;
  probe.to(distance_mm * through);
  test::CostSample sample(static_cast<std::size_t>(ticks));
  Loop seen;
  Vec3 before_N = probe.force(1.0), last_W = distance_mm * through;
  for (int i = 1; i <= ticks; ++i)
  {
    const double a = 2 * std::numbers::pi * i / ticks;
    const Vec3 p_W = distance_mm * (std::cos(a) * through + std::sin(a) * along);
    sample.time([&] { probe.to(p_W); });
    const Vec3 force_N = probe.force(1.0);
    seen.off_deg = std::max(seen.off_deg, angle_deg(force_N, p_W));
    seen.jump_deg = std::max(seen.jump_deg, angle_deg(force_N, before_N) - angle_deg(p_W, last_W));
    seen.work_mJ += 0.5 * (force_N + before_N).dot(p_W - last_W);
    before_N = force_N;
    last_W = p_W;
  }
  seen.cost = Cost::of(sample);
  return seen;
}

} // namespace force_shading_experiment

void runForceShading(const Conditions& conditions, Table& table)
{
  using namespace force_shading_experiment;
  const int ticks = conditions.pick(5000, 20000, 100000);
  const TriangleMesh mesh = test::makeIcosphere(3, sphere_mm);
  const auto scene = test::sceneOf(mesh);
  const test::WorstFacets facets = test::worstOf(mesh);
  for (const double ball_mm : { 0.0, 1.0 })
  {
    for (const double depth_mm : { 0.5, 1.0, 5.0 })
    {
      const std::string name = caseName({ { "r_mm", ball_mm }, { "depth_mm", depth_mm } });
      const Loop plain = rub(scene, facets.faceNormal, false, ball_mm, depth_mm, ticks);
      const Loop shaded = rub(scene, facets.faceNormal, true, ball_mm, depth_mm, ticks);
      if (ball_mm == 0.0) // a ball rolls over an edge instead of leaping
      {
        table.atLeast({ name, "god-object", "largest jump of direction", "degrees" }, plain.jump_deg, 5.0);
      }
      table.atMost({ name, "shaded", "largest jump of direction", "degrees" }, shaded.jump_deg, 0.2).cost = shaded.cost;
      // A ball stands over its foot along the normal of the face, which is up to 5.46 degrees off the sphere's.
      const double lean_deg = 5.46 * ball_mm / (sphere_mm + ball_mm - depth_mm);
      table.atMost(
        { name, "shaded", "largest angle to the sphere's normal", "degrees" }, shaded.off_deg, lean_deg + 0.01);
      table.atMost({ name, "shaded", "work of a closed way over K p^2 / 2" },
        std::abs(shaded.work_mJ) / (0.5 * depth_mm * depth_mm), 0.01);
      table
        .info({ name, "god-object", "work of a closed way over K p^2 / 2" },
          std::abs(plain.work_mJ) / (0.5 * depth_mm * depth_mm))
        .cost = plain.cost;
    }
  }
}

} // namespace palpate::lab
