// SPDX-License-Identifier: GPL-3.0-or-later
// Row 8: a plate much thinner than the push.
#include <algorithm>
#include <string>

#include "testing/lab/Experiments.h"
#include "testing/lab/methods/ContactMethod.h"
#include "testing/lab/methods/Textbook.h"
#include "testing/support/Meshes.h"

namespace palpate::lab
{
namespace thin_plate_experiment
{

constexpr double stiffness_N_per_m = 1000.0, step_m = 1e-5;

/// Figures of a push of 5 mm in steps of 10 um.
struct Push
{
  double worst_N = 0.0;       ///< largest |F - K p n|
  double largestStep_N = 0.0; ///< largest change of the force in a step
  double flip_m = 0.0;        ///< first depth at which the force points into the plate; 0: never
};

Push push(const World& world, const MethodKind& kind)
{
  const auto method = kind.make(world);
  method->start({ 0.003, 0.004, 0.01 });
  Push seen;
  Vec3 before_N = Vec3::Zero();
  for (int step = 0; step <= 500; ++step)
  {
    const double depth_m = step * step_m;
    const Vec3 force_N = stiffness_N_per_m * method->tick({ 0.003, 0.004, kind.radius_m - depth_m }).force_u;
    seen.worst_N = std::max(seen.worst_N, (force_N - stiffness_N_per_m * depth_m * Vec3::UnitZ()).norm());
    seen.largestStep_N = std::max(seen.largestStep_N, step == 0 ? 0.0 : (force_N - before_N).norm());
    seen.flip_m = seen.flip_m == 0.0 && force_N.z() < 0 ? depth_m : seen.flip_m;
    before_N = force_N;
  }
  return seen;
}

void judgeHeld(
  const World& world, const std::string& caseName, const std::string& name, double tolerance_N, Table& table)
{
  const Push seen = push(world, method(name));
  table.atMost({ caseName, name, "force error", "N" }, seen.worst_N, tolerance_N);
  table.within(
    { caseName, name, "largest force step", "N" }, seen.largestStep_N, stiffness_N_per_m * step_m, tolerance_N);
  table.within({ caseName, name, "flip depth, 0 = never", "m" }, seen.flip_m, 0.0, 0.0);
}

} // namespace thin_plate_experiment

void runThinPlate(const Conditions&, Table& table)
{
  using namespace thin_plate_experiment;
  for (const double thickness_m : { 0.1e-3, 0.5e-3, 2e-3 })
  {
    const World world(test::makeBox({ -0.05, -0.05, -thickness_m }, { 0.05, 0.05, 0 }));
    const std::string caseName = "thickness=" + std::to_string(1e3 * thickness_m).substr(0, 3) + "mm";
    judgeHeld(world, caseName, "god-object r=0", 1e-9, table);
    judgeHeld(world, caseName, "god-object r=1mm", 1e-9, table);
    // A method that keeps a gap errs by the stiffness times the gap: in the first step by twice that.
    judgeHeld(world, caseName, "textbook-loop", 2 * stiffness_N_per_m * gap_u, table);

    // The nearest face of a plate is its back from half the thickness on: there the force turns from K t/2 to -K t/2.
    const Push seen = push(world, method("penalty"));
    table.within({ caseName, "penalty", "flip depth, 0 = never", "m" }, seen.flip_m, thickness_m / 2, 1.001 * step_m);
    table.within({ caseName, "penalty", "largest force step", "N" }, seen.largestStep_N,
      stiffness_N_per_m * thickness_m, 1.001 * stiffness_N_per_m * step_m);
  }
}

} // namespace palpate::lab
