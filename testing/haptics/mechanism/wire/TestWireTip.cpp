// SPDX-License-Identifier: GPL-3.0-or-later
// A wire whose tip is bent by 45 degrees in a straight tube, pushed, turned and pulled back, against the statics of a
// kinked beam.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "haptics/contact/view/ContactPlan.h"
#include "testing/support/WireTube.h"

namespace palpate::test
{
namespace
{

constexpr double step_mm = 0.1; // a tick: .1 m/s
constexpr double tipFriction = 0.1, tip_mm = 8.0;

WireDescription bentWire(double whole_mm, int beams)
{
  WireDescription wire = nitinolWire(whole_mm, beams, tipFriction);
  wire.shape.tip = WireTip::Angled;
  wire.shape.tip_u = tip_mm;
  return wire;
}

/// A thin beam with a kink by `angle`, a length `tip` from its end, between two walls 2 c apart: its end and a place b
/// behind the kink press one wall, the kink the other. Behind b it is straight along the wall, so that the moment falls
/// in a straight line from M at the kink to 0 at both ends. In b the deflection is M b^2 / (6 E I) = 2 c, the slope at
/// the kink M b / (2 E I) = 6 c / b. In the tip (angle - 6 c / b) tip - M tip^2 / (3 E I) = 2 c. Slopes are small.
struct KinkedBeam
{
  double bend_Nmm2;
  double clearance_mm;
  double tip;
  double angle;

  /// Sum of the forces of the walls.
  [[nodiscard]] double walls_N() const
  {
    const double c = this->clearance_mm;
    const double p = this->angle * this->tip - 2.0 * c, q = 6.0 * c * this->tip, r = 4.0 * c * this->tip * this->tip;
    const double b = (q + std::sqrt(q * q + 4.0 * p * r)) / (2.0 * p);
    const double moment_Nmm = 12.0 * c * this->bend_Nmm2 / (b * b);
    return 2.0 * (moment_Nmm / this->tip + moment_Nmm / b);
  }
};

constexpr double wireRadius_mm = 0.25;

double kinkWalls_N()
{
  const double bend_Nmm2 = roundSection(wireRadius_mm, 60e3, 0.3).bend_Nu2;
  return KinkedBeam{ bend_Nmm2, 1.0 - wireRadius_mm, tip_mm, 0.25 * std::numbers::pi }.walls_N();
}

TEST(WireTip, PushedAndPulledAt100MillimetresASecondItFeelsTheFrictionOfAKinkedBeamAndNoDrag)
{
  const double friction_N = tipFriction * kinkWalls_N();
  for (const auto& [whole_mm, beams] : { std::pair(100.0, 25), std::pair(96.0, 48) })
  {
    PushedWire wire(bentWire(whole_mm, beams), Tube{ .first_mm = 100.0, .around = 64, .ring_mm = 2.0 }.mesh());
    double sum_N = 0.0, pulled_N = 0.0;
    constexpr int pushed = 450, last = 50;
    for (int i = 0; i < pushed; ++i)
    {
      const double force_N = -wire.tick(step_mm * i).wrench_W.force.x();
      sum_N += i < pushed - last ? 0.0 : force_N;
    }
    for (int i = 0; i < 2 * last; ++i)
    {
      const double force_N = wire.tick(step_mm * (pushed - i)).wrench_W.force.x();
      pulled_N += i < last ? 0.0 : force_N;
    }
    EXPECT_NEAR(sum_N / last, friction_N, 0.06 * friction_N) << beams;
    EXPECT_GT(pulled_N / last, 0.7 * friction_N) << beams; // a kink that is pulled lies flatter
    EXPECT_LT(pulled_N / last, 1.06 * friction_N) << beams;
  }
}

/// Beams that are nearly as long as the tip: behind the mouth such a tip once turned out of the vessel.
TEST(WireTip, TurnedInATubeAndPulledItIsAsStrongAsItsFrictionAndComesFree)
{
  for (const auto& [whole_mm, beams] : { std::pair(100.0, 16), std::pair(200.0, 32), std::pair(200.0, 24) })
  {
    PushedWire wire(bentWire(whole_mm, beams), Tube{ .first_mm = 60.0, .around = 24, .ring_mm = 2.0 }.mesh());
    wire.turning_Nmm_per_rad = 0.5;
    wire.budget = ContactPlan().workBudget;
    constexpr double deep_mm = 25.0; // from there on all three places are out of the sheath
    double most_N = 0.0, far_mm = 0.0, off_N = 0.0;
    int notAtRest = 0;
    const auto see = [&](const WireResult& result)
    {
      const double force_N = result.wrench_W.force.x();
      most_N = result.pushed_u > deep_mm ? std::max(most_N, std::abs(force_N)) : most_N;
      double wall_N = 0.0;
      for (int i = 0; i < result.pressCount; ++i)
      {
        wall_N += result.presses[i].force_M.x();
      }
      off_N = result.capped ? off_N : std::max(off_N, std::abs(force_N - wall_N));
      notAtRest += result.capped ? 1 : 0;
      for (const Pose& node : wire.ticks.state().places_M)
      {
        far_mm = node.p.x() > 0.0 ? std::max(far_mm, node.p.tail<2>().norm()) : far_mm;
      }
    };
    constexpr int pushed = 300, turned = 1600, pulled = 320;
    constexpr double turn_rad = 4e-3; // a tick
    for (int i = 0; i <= pushed + turned + pulled; ++i)
    {
      const int out = std::min(i, pushed) - std::max(i - pushed - turned, 0);
      see(wire.tick(step_mm * out, turn_rad * std::clamp(i - pushed, 0, turned)));
    }
    EXPECT_GT(most_N, 0.5 * tipFriction * kinkWalls_N()) << beams;
    EXPECT_LE(most_N, tipFriction * kinkWalls_N()) << beams;
    EXPECT_LE(off_N, 0.01) << "the sheath neither pushes nor brakes";
    EXPECT_LE(notAtRest, (pushed + turned + pulled) / 50);
    EXPECT_LE(far_mm, 1.0 - wireRadius_mm) << "the tube is round, and its walls lie within";
    EXPECT_EQ(wire.ticks.state().pressCount, 0);
    EXPECT_LE(wire.tick(-step_mm * (pulled - pushed)).wrench_W.force.norm(), 1e-9);
  }
}

} // namespace
} // namespace palpate::test
