// SPDX-License-Identifier: GPL-3.0-or-later
// Row 17, chart C1: the effect of the facets of an inscribed sphere on the force, and the cost of a tick.
#include "testing/support/Facets.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "testing/lab/Experiments.h"
#include "testing/lab/methods/ContactMethod.h"
#include "testing/support/Meshes.h"

namespace palpate::lab
{
namespace facets_experiment
{

constexpr double radius_mm = 50.0, depth_mm = 1.0;

struct Rubbing
{
  double worst = 0.0; ///< largest error of the force's magnitude [relative]
  Cost cost;
};

/// Once round a great circle through the middle of the worst face, 1 mm below the true sphere.
Rubbing rub(const World& world, const MethodKind& kind, const Vec3& through, int ticks)
{
  const Vec3 along = through.unitOrthogonal();
  const double distance_mm = radius_mm + 1e3 * kind.radius_m - depth_mm;
  const auto proxy = kind.make(world);
  proxy->start(60.0 * through);
  test::CostSample sample(static_cast<std::size_t>(ticks));
  Rubbing seen;
  for (int i = 0; i < ticks; ++i)
  {
    const double a = 2 * std::numbers::pi * i / ticks;
    MethodTick tick;
    sample.time([&] { tick = proxy->tick(distance_mm * (std::cos(a) * through + std::sin(a) * along)); });
    seen.worst = std::max(seen.worst, std::abs(tick.force_u.norm() - depth_mm) / depth_mm);
  }
  seen.cost = Cost::of(sample);
  return seen;
}

} // namespace facets_experiment

void runFacets(const Conditions& conditions, Table& table)
{
  using namespace facets_experiment;
  constexpr int coarsest = 2;
  const int finest = conditions.pick(6, 7, 8);
  for (int levels = coarsest; levels <= finest; ++levels)
  {
    const TriangleMesh mesh = test::makeIcosphere(levels, radius_mm);
    const World world(mesh, 1e3);
    const test::WorstFacets facets = test::worstOf(mesh);
    const auto triangles = static_cast<double>(mesh.triangles.size());
    const std::string caseName = "triangles=" + std::to_string(mesh.triangles.size());
    for (const std::string name : { "god-object r=0", "god-object r=1mm" })
    {
      const Rubbing seen = rub(world, method(name), facets.faceNormal, conditions.pick(1000, 8000, 40000));
      // A spring of 1 N/mm is short by the sagitta of the face, a ball by no more.
      const double truth = (radius_mm - facets.faceRadius_u) / depth_mm;
      table.within({ caseName, name, "force error", "" }, seen.worst, truth, 1e-9).cost = seen.cost;
      if (triangles >= 5120)
      {
        const double fit = 5.83 * radius_mm / (triangles * depth_mm);
        table.within({ caseName, name, "force error against the fit 5.83 R / (N p)", "" }, seen.worst, fit, 0.02 * fit);
      }
    }
    conditions.progress((levels - coarsest + 1.0) / (finest - coarsest + 1.0));
  }
}

} // namespace palpate::lab
