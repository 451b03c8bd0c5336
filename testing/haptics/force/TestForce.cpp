// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "haptics/force/VirtualCoupling.h"
#include "haptics/force/WorkspaceMap.h"
#include "haptics/tick/HapticParameters.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

TEST(WorkspaceMap, GoesToTheSceneAndBackAtEveryScaleRotationAndOffset)
{
  test::Random random(test::testSeed(61));
  for (std::size_t i = 0; i < test::testCount(1000); ++i)
  {
    WorkspaceMap map;
    map.scale_u_per_m = std::pow(10.0, random.uniform(-6, 6));
    map.q_WD = Quat(Eigen::AngleAxisd(random.uniform(-3, 3), random.direction()));
    map.offset_W = map.scale_u_per_m * random.inCube(1.0);
    const Vec3 p_D = random.inCube(0.2), v_D = random.inCube(1.0);
    ASSERT_LE((map.toDevice(map.toScene(p_D)) - p_D).norm(), 1e-14) << "case " << i;
    ASSERT_LE((map.directionToDevice(map.directionToScene(v_D)) - v_D).norm(), 1e-14) << "case " << i;
    // The map is affine: a step of the hand is a step in the scene, turned and scaled.
    const Vec3 step_W = map.toScene(p_D + v_D) - map.toScene(p_D);
    ASSERT_LE((step_W - map.scale_u_per_m * map.directionToScene(v_D)).norm(), 1e-14 * map.scale_u_per_m);
  }
}

TEST(VirtualCoupling, IsASpringPlusADamperAlongItThatNeverPulls)
{
  const Vec3 n = Vec3(1, 2, 2) / 3.0, along = Vec3(2, 1, -2) / 3.0; // unit and perpendicular
  const double K = 800.0, b = 4.0, depth_m = 0.002, speed = 0.3;
  const auto force = [&](const Vec3& velocity) { return coupleDevice(depth_m * n, velocity, K, b); };
  EXPECT_LE((force(-speed * n) - (K * depth_m + b * speed) * n).norm(), 1e-14); // deeper: resists
  EXPECT_LE((force(speed * n) - (K * depth_m - b * speed) * n).norm(), 1e-14);  // out: gives back less
  EXPECT_LE(force(10.0 * n).norm(), 1e-14);                                     // far faster: the clamp, no pull
  EXPECT_LE((force(speed * along) - K * depth_m * n).norm(), 1e-14);            // along: no friction
  EXPECT_LE((force(speed * along - speed * n) - (K * depth_m + b * speed) * n).norm(), 1e-14);
}

TEST(VirtualCoupling, GivesNothingInFreeSpaceAtAnySpeed)
{
  EXPECT_EQ(coupleDevice(Vec3::Zero(), { 1, -5, 2 }, 800.0, 4.0), Vec3::Zero());
}

TEST(HapticParameters, RefuseEachValueThatCannotBeByName)
{
  struct Case
  {
    const char* named;
    double HapticParameters::*value;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(HapticParameters().validate(), "");
  for (const double bad : { -1.0, nan, infinity })
  {
    for (const Case& c : { Case{ "stiffness", &HapticParameters::stiffness_N_per_m },
           Case{ "damping", &HapticParameters::damping_Ns_per_m }, Case{ "blend", &HapticParameters::sceneBlend_s } })
    {
      HapticParameters parameters;
      parameters.*c.value = bad;
      EXPECT_NE(parameters.validate().find(c.named), std::string::npos) << c.named << ' ' << bad;
    }
    HapticParameters parameters;
    parameters.contact.radius_u = bad;
    EXPECT_NE(parameters.validate().find("radius"), std::string::npos) << bad;
    parameters = {};
    parameters.map.scale_u_per_m = bad;
    EXPECT_NE(parameters.validate().find("scale"), std::string::npos) << bad;
    parameters = {};
    parameters.map.offset_W.y() = bad;
    EXPECT_EQ(parameters.validate().empty(), bad == -1.0) << bad;
  }
}

// They come from recordings, too.
TEST(HapticParameters, RefuseATickWithoutEndOrWithoutWork)
{
  for (std::uint32_t ContactPlan::*bound : { &ContactPlan::passCap, &ContactPlan::workBudget })
  {
    for (const std::uint32_t bad : { 0U, 1U << 30, std::numeric_limits<std::uint32_t>::max() })
    {
      HapticParameters parameters;
      parameters.contact.*bound = bad;
      EXPECT_NE(parameters.validate().find("work limit of a tick"), std::string::npos) << bad;
    }
  }
}

TEST(HapticParameters, RefuseSafetyLimitsThatWouldLimitNothing)
{
  for (double SafetyLimits::*limit :
    { &SafetyLimits::maxForce_N, &SafetyLimits::maxRise_N_per_s, &SafetyLimits::engageRamp_s,
      &SafetyLimits::engageBelow_N, &SafetyLimits::releaseRamp_s, &SafetyLimits::faultRamp_s })
  {
    for (const double bad : { -1.0, std::numeric_limits<double>::quiet_NaN() })
    {
      HapticParameters parameters;
      parameters.safety.*limit = bad;
      EXPECT_NE(parameters.validate().find("safety limits"), std::string::npos) << bad;
    }
  }
  HapticParameters parameters;
  parameters.safety = SafetyLimits::none();
  EXPECT_EQ(parameters.validate(), "");
}

} // namespace
} // namespace palpate
