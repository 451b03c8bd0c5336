// SPDX-License-Identifier: GPL-3.0-or-later
// Boxes on a slope and on one another: they stay or go where statics says. Friction as a steep damper creeps.
#include <algorithm>
#include <cmath>
#include <string>

#include "testing/haptics/mechanism/LooseScenes.h"
#include "testing/lab/Experiments.h"

namespace palpate::lab
{
namespace loose_experiment
{

constexpr double friction = 0.4, second_s = 1.0;

double tiltOf(double share)
{
  return std::atan(share * friction);
}

/// How far a box slides in a second from rest, by Coulomb's law [m].
double coulomb_m(double tilt_rad)
{
  const double drive = std::sin(tilt_rad) - friction * std::cos(tilt_rad);
  return 0.5 * test::gravity_m_per_s2 * std::max(0.0, drive) * second_s * second_s;
}

/// The same with a friction that grows with the speed up to Coulomb's, as it is below 1 mm/s [m].
double damper_m(double tilt_rad)
{
  constexpr double whole_m_per_s = 1e-3, step_s = 1e-5;
  double x_m = 0.0, v_m_per_s = 0.0;
  for (double t = 0.0; t < second_s; t += step_s)
  {
    const double braked = friction * std::cos(tilt_rad) * std::min(1.0, v_m_per_s / whole_m_per_s);
    v_m_per_s += step_s * test::gravity_m_per_s2 * (std::sin(tilt_rad) - braked);
    x_m += step_s * v_m_per_s;
  }
  return x_m;
}

void onSlopes(Table& table)
{
  for (const double share : { 0.8, 0.98, 1.02, 1.1, 1.2, 1.4 })
  {
    const double tilt_rad = tiltOf(share), truth_m = coulomb_m(tilt_rad);
    const std::string slope = caseName({ { "slope", share } });
    const Subject ours{ slope, "ours", "slid in a second", "m" };
    table.within(ours, test::slid_m(tilt_rad, friction), truth_m, std::max(1e-7, 0.01 * truth_m));
    const Subject damper{ slope, "friction as a damper", "slid in a second", "m" };
    const double creeps_m = damper_m(tilt_rad);
    share < 1.0 ? table.atLeast(damper, creeps_m, 1e-4) : table.info(damper, creeps_m);
  }
}

void onOneAnother(Table& table)
{
  for (const int pushed : { 0, 1, 2 })
  {
    const std::string box = caseName({ { "box", pushed } });
    const test::Stack::Limit limit = test::Stack().limitOf(pushed);
    table.info({ box, limit.tips ? "statics: tips" : "statics: slides", "largest force", "N" }, limit.force_N);
    table.atMost({ box, "ours, pushed by .99 of it", "moved", "m" }, test::pushStack(pushed, 0.99).most_m, 1e-5);
    table.atLeast({ box, "ours, pushed by 1.01 of it", "moved", "m" }, test::pushStack(pushed, 1.01).most_m, 1e-3);
  }
}

} // namespace loose_experiment

void runLoose(const Conditions& conditions, Table& table)
{
  loose_experiment::onSlopes(table);
  conditions.progress(0.7);
  loose_experiment::onOneAnother(table);
}

} // namespace palpate::lab
