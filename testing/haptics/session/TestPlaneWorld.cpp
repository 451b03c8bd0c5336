// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "haptics/session/plan/PlaneWorld.h"
#include "haptics/session/scene/SimplifyPlan.h"
#include "testing/support/Says.h"

namespace palpate
{
namespace
{

using ::testing::HasSubstr;
using ::testing::Not;

constexpr double held_N_per_m = 300.0;

/// A joystick that closes walls itself, which was felt.
DeviceInfo joystick()
{
  DeviceInfo device;
  device.abilities.sensedAxes = 2;
  device.abilities.holdsWalls = device.abilities.viscous = device.offersWalls = true;
  device.heldProof = HeldProof::Felt;
  device.heldStiffness_N_per_m.value = held_N_per_m;
  return device;
}

Pose leaning()
{
  return { Vec3(1.0, 2.0, 3.0), Quat(Eigen::AngleAxisd(0.3, Vec3::UnitY())) };
}

HapticParameters across(const Pose& plane_WP)
{
  HapticParameters parameters;
  parameters.map.q_WD = plane_WP.q;
  return parameters;
}

TEST(PlaneWorld, LinesAreWallsWhereThatIsAskedForOrTheDeviceMovesInAPlane)
{
  for (const DeviceInfo& device : { DeviceInfo(), joystick() })
  {
    EXPECT_TRUE(raisesLines(AutoChoice::On, device));
    EXPECT_FALSE(raisesLines(AutoChoice::Off, device));
  }
  EXPECT_TRUE(raisesLines(AutoChoice::Auto, joystick()));
  EXPECT_FALSE(raisesLines(AutoChoice::Auto, DeviceInfo()));
}

TEST(PlaneWorld, AHandInSpaceIsLedToThePlaneAndHoldsNoWalls)
{
  const HapticParameters in = inPlane(across(leaning()), leaning(), {}, DeviceInfo());
  EXPECT_TRUE(in.guide.on);
  EXPECT_EQ(in.guide.point_W, leaning().p);
  EXPECT_NEAR((in.guide.normal_W - Vec3(std::sin(0.3), 0.0, std::cos(0.3))).norm(), 0.0, 1e-15);
  EXPECT_EQ(in.guide.largest_N, GuidePlan().largest_N);
  EXPECT_FALSE(in.walls.hold);
  EXPECT_FALSE(inPlane(across(leaning()), leaning(), { true, false }, DeviceInfo()).guide.on);
  EXPECT_FALSE(inPlane(in, std::nullopt, {}, DeviceInfo()).guide.on); // it ends with the plane
}

TEST(PlaneWorld, AJoystickHoldsWallsOfAPlaneThatLiesAcrossItAndIsNotPushedOutOfIt)
{
  const HapticParameters in = inPlane(across(leaning()), leaning(), {}, joystick());
  EXPECT_TRUE(in.walls.hold);
  EXPECT_EQ(in.guide.largest_N, 0.0);
  EXPECT_FALSE(inPlane(across(leaning()), leaning(), { false, true }, joystick()).walls.hold);
  EXPECT_FALSE(inPlane(HapticParameters(), leaning(), {}, joystick()).walls.hold);
  EXPECT_FALSE(inPlane(in, std::nullopt, {}, joystick()).walls.hold);
}

TEST(PlaneWorld, AHandFeelsNoMoreStiffnessThanWhoClosesTheWallCanHold)
{
  HapticParameters parameters;
  parameters.stiffness_N_per_m = 1000.0;
  StabilityLimits limits;
  EXPECT_EQ(feltStiffness_N_per_m(parameters, joystick(), limits), 1000.0);
  limits.largest_N_per_m = 800.0;
  EXPECT_EQ(feltStiffness_N_per_m(parameters, joystick(), limits), 800.0);
  parameters.walls.hold = true;
  EXPECT_EQ(feltStiffness_N_per_m(parameters, joystick(), limits), held_N_per_m);
  EXPECT_EQ(feltStiffness_N_per_m(parameters, DeviceInfo(), limits), 800.0); // that holds none
}

TEST(PlaneWorld, ASlideAlongASlantIsBrakedInProportionToTheStiffnessAndTheTimeBetweenMoves)
{
  HapticParameters parameters;
  const double once = slantDrag_N(parameters, 100.0, 1e-3);
  EXPECT_GT(once, 0.0);
  EXPECT_NEAR(slantDrag_N(parameters, 200.0, 1e-3), 2.0 * once, 1e-12);
}

TEST(PlaneWorld, SaysWhoClosesTheWallsAndWhy)
{
  HapticParameters parameters = inPlane(across(leaning()), leaning(), {}, joystick());
  parameters.walls.every_s = 1.0 / 125.0;
  const auto said = [&](const PlaneWishes& wishes, const DeviceInfo& device)
  { return planeText(inPlane(parameters, leaning(), wishes, device), wishes, device, 0.25, "of its colour"); };
  EXPECT_TRUE(test::says(said({}, joystick()), { "updated", "125 Hz", "sliding", "0.1 m/s", "0.25 N" }));
  EXPECT_TRUE(test::says(said({ false, true }, joystick()), { "program renders the walls", "as set" }));
  EXPECT_TRUE(test::says(said({}, DeviceInfo()), { "device holds none", "guided" }));
  EXPECT_THAT(said({ true, false }, DeviceInfo()), Not(HasSubstr("led")));
  DeviceInfo stiff = joystick();
  stiff.abilities.viscous = stiff.offersWalls = false;
  EXPECT_TRUE(test::says(said({}, stiff), { "viscosity", "corridors", "vibrate" }));
  DeviceInfo unfelt = joystick();
  unfelt.heldProof = HeldProof::Unfelt;
  EXPECT_TRUE(test::says(said({}, unfelt), { "offers walls", "of its colour" }));
  parameters.map.q_WD = Quat::Identity();
  EXPECT_TRUE(test::says(said({}, joystick()), { "because the plane is not" }));
}

TEST(SimplifyPlan, FollowsTheScaleTheDeviceAndTheChoice)
{
  DeviceInfo device;
  device.resolution_m.value = 1e-5;
  const SimplifyPlan plan = simplifyPlan(AutoChoice::Auto, 500.0, device);
  EXPECT_EQ(plan.rules.touch.scale_u_per_m, 500.0);
  EXPECT_EQ(plan.rules.touch.resolution_m, 1e-5);
  EXPECT_EQ(plan.rules.leastTriangles, SimplifyRules().leastTriangles);
  EXPECT_FALSE(plan.off);
  EXPECT_EQ(plan, simplifyPlan(AutoChoice::Auto, 500.0, device));
  EXPECT_EQ(simplifyPlan(AutoChoice::On, 500.0, device).rules.leastTriangles, 0u);
  EXPECT_EQ(simplifyPlan(AutoChoice::On, 500.0, device).rules.leastFine, 0u);
  EXPECT_TRUE(simplifyPlan(AutoChoice::Off, 500.0, device).off);
  for (const AutoChoice choice : { AutoChoice::On, AutoChoice::Off })
  {
    EXPECT_FALSE(plan == simplifyPlan(choice, 500.0, device));
  }
  EXPECT_FALSE(plan == simplifyPlan(AutoChoice::Auto, 501.0, device));
  device.resolution_m.value = 2e-5;
  EXPECT_FALSE(plan == simplifyPlan(AutoChoice::Auto, 500.0, device));
}

} // namespace
} // namespace palpate
