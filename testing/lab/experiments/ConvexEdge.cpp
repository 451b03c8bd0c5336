// SPDX-License-Identifier: GPL-3.0-or-later
// Row 10: from the top of a box over its edge (x = 0.05 m, z = 0), the device 1 mm deep.
#include <algorithm>
#include <cmath>
#include <string>

#include "testing/lab/Experiments.h"
#include "testing/lab/methods/ContactMethod.h"
#include "testing/lab/methods/Textbook.h"
#include "testing/support/Meshes.h"

namespace palpate::lab
{
namespace convex_edge_experiment
{

constexpr double stiffness_N_per_m = 1000.0, edge_m = 0.05, depth_m = 1e-3;

/// A path over the edge in equal steps, one of which ends `offset_m` behind it.
struct Way
{
  std::string name;
  double step_m, offset_m;
  int before, after; ///< steps on either side
};

/// The force of a wall of 1000 N/m: straight up above the top; past the edge none on a point, and on a ball the force
/// of the side.
Vec3 truth_N(double x_m, double radius_m)
{
  return stiffness_N_per_m *
         (x_m < edge_m ? Vec3(0, 0, radius_m + depth_m) : Vec3(std::max(0.0, edge_m + radius_m - x_m), 0, 0));
}

struct Passage
{
  double late_m = 0.0;  ///< how far past the edge the device was when the top let go
  int lateTicks = 0;    ///< ticks past the edge in which the top still pushed
  double worst_N = 0.0; ///< largest force error
  double largestStep_N = 0.0;
  Vec3 last_N = Vec3::Zero();
};

Passage pass(const World& world, const MethodKind& kind, const Way& way)
{
  const auto proxy = kind.make(world);
  proxy->start({ edge_m - 5e-3, 0.01, 3e-3 });
  (void)proxy->tick({ edge_m - 3e-3, 0.01, -depth_m });
  Passage seen;
  for (int i = -way.before; i <= way.after; ++i)
  {
    const double x_m = edge_m + way.offset_m + i * way.step_m;
    const Vec3 force_N = stiffness_N_per_m * proxy->tick({ x_m, 0.01, -depth_m }).force_u;
    seen.worst_N = std::max(seen.worst_N, (force_N - truth_N(x_m, kind.radius_m)).norm());
    if (x_m > edge_m && force_N.z() > 0.01)
    {
      seen.late_m = x_m - edge_m;
      ++seen.lateTicks;
    }
    seen.largestStep_N = std::max(seen.largestStep_N, i == -way.before ? 0.0 : (force_N - seen.last_N).norm());
    seen.last_N = force_N;
  }
  return seen;
}

void judgeOurs(const World& world, const Way& way, Table& table)
{
  for (const std::string name : { "god-object r=0", "god-object r=1mm" })
  {
    const Passage seen = pass(world, method(name), way);
    table.within({ way.name, name, "release past the edge", "m" }, seen.late_m, 0.0, 1e-6);
    table.atMost({ way.name, name, "force error", "N" }, seen.worst_N, 1e-6);
  }
}

/// Methods that look for contact from the proxy to the device anew see that the top has ended one tick late.
void judgeLate(const World& world, const Way& way, Table& table)
{
  for (const std::string name : { "point-no-side", "one-constraint", "alternating" })
  {
    table.within(
      { way.name, name, "ticks held past the edge", "" }, pass(world, method(name), way).lateTicks, 1.0, 0.0);
  }
}

void judgeGlued(const World& world, const Way& way, Table& table)
{
  const double past_m = way.offset_m + way.after * way.step_m, tolerance_N = 4 * stiffness_N_per_m * gap_u;
  const double top_N = stiffness_N_per_m * depth_m;
  // Carried over, the top goes on beyond its edge.
  table.within({ way.name, "textbook-loop", "force past the edge", "N" },
    pass(world, method("textbook-loop"), way).last_N.norm(), top_N, tolerance_N);
  // With the side as a wall without end as well the proxy hangs at the edge itself.
  table.within({ way.name, "half-spaces", "force past the edge", "N" },
    pass(world, method("half-spaces"), way).last_N.norm(), std::hypot(top_N, stiffness_N_per_m * past_m), tolerance_N);
}

} // namespace convex_edge_experiment

void runConvexEdge(const Conditions&, Table& table)
{
  using namespace convex_edge_experiment;
  const World world(test::makeBox({ -edge_m, -edge_m, -0.1 }, { edge_m, edge_m, 0 }));
  const Way slow{ "step=1um", 1e-6, 3e-7, 1500, 200 };
  const Way fast{ "step=100um", 1e-4, 2e-5, 25, 30 }; // 100 mm/s
  for (const Way& way : { slow, fast })
  {
    judgeOurs(world, way, table);
    judgeGlued(world, way, table);
    judgeLate(world, way, table);
    // Where the side is as near as the top the force turns by a right angle: sqrt(2) K p.
    table.within({ way.name, "penalty", "largest force step", "N" }, pass(world, method("penalty"), way).largestStep_N,
      std::sqrt(2.0) * stiffness_N_per_m * depth_m, 1.5 * stiffness_N_per_m * way.step_m);
  }
}

} // namespace palpate::lab
