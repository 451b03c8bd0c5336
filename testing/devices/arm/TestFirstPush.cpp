// SPDX-License-Identifier: GPL-3.0-or-later
// The check of an arm of each kit, in virtual time: the pushes go through the whole device to the motors of the arm's
// model, and move a light hand there.
#include <algorithm>

#include <gtest/gtest.h>

#include "devices/calibration/SelfTest.h"
#include "devices/calibration/SelfTestText.h"
#include "haptics/force/LinearPlant.h"
#include "testing/devices/arm/SessionArms.h"

namespace palpate::test
{
namespace
{

constexpr double tick_s = 1e-3;

/// A light hand on the arm: a mass on a spring and a damper about the middle of the work space.
struct LightHand
{
  LinearPlant plant{ 0.12, 4.0, 200.0, tick_s };
  Vec3 p_m = Vec3::Zero(), v_m_per_s = Vec3::Zero();
};

struct FirstPushes
{
  SelfTestPlan plan;
  SelfTestState state;
  double largest_N = 0.0; ///< in the hand
};

/// `motors`: from the force of the arm's model to that on the hand; the identity on an arm that is wired rightly.
template<class Arm>
FirstPushes push(const Mat3& motors = Mat3::Identity())
{
  constexpr int longest_ticks = 200000;
  Arm arm;
  FirstPushes pushes;
  EXPECT_EQ(arm.open(), "");
  pushes.plan = SelfTestPlan::forDevice(arm.device().info());
  EXPECT_EQ(pushes.plan.refusal(), "");
  LightHand hand;
  for (int tick = 1; tick < longest_ticks && pushes.state.verdict == SelfTestVerdict::None; ++tick)
  {
    const Vec3 force_N = arm.force_N();
    pushes.largest_N = std::max(pushes.largest_N, force_N.norm());
    hand.plant.step(hand.p_m, hand.v_m_per_s, motors * force_N);
    hand.p_m.z() = arm.inPlane() ? 0.0 : hand.p_m.z();
    arm.lead(hand.p_m);
    static_cast<void>(arm.pass());
    DeviceSample sample;
    const DeviceStatus status = arm.device().read(tick * tick_s, sample);
    arm.device().write(stepSelfTest(pushes.plan, sample, status, tick_s, pushes.state));
  }
  return pushes;
}

template<class Arm>
class FirstPush : public testing::Test
{
};

TYPED_TEST_SUITE(FirstPush, SessionArms);

TYPED_TEST(FirstPush, PassesOnAnArmThatIsWiredRightlyWithHalfANewtonAtMost)
{
  const FirstPushes pushes = push<TypeParam>();
  EXPECT_EQ(pushes.state.verdict, SelfTestVerdict::Passed) << resultOf(pushes.plan, pushes.state);
  const TypeParam arm;
  EXPECT_EQ(pushes.plan.axes, arm.inPlane() ? 2 : 3);
  EXPECT_GT(pushes.largest_N, 0.4);
  // To a step of the motors, and by the share that a place of the exchange before leaves.
  EXPECT_LE(pushes.largest_N, 0.5 * (1.0 + arm.ofThePlace()) + arm.step_N());
}

TYPED_TEST(FirstPush, TellsAMotorThatPushesTheOtherWay)
{
  for (int axis = 0; axis < 2; ++axis)
  {
    Mat3 motors = Mat3::Identity();
    motors(axis, axis) = -1.0;
    const FirstPushes pushes = push<TypeParam>(motors);
    EXPECT_EQ(pushes.state.verdict, SelfTestVerdict::Faulty);
    EXPECT_EQ(pushes.state.reason, SelfTestReason::Reversed) << resultOf(pushes.plan, pushes.state);
  }
}

} // namespace
} // namespace palpate::test
