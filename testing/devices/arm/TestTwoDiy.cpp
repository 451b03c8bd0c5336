// SPDX-License-Identifier: GPL-3.0-or-later
// The whole chain of a 2DIY, against a model of its board and its pantograph.
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "devices/DeviceFactory.h"
#include "devices/arm/protocol/TwoDiyWire.h"
#include "devices/calibration/SelfTest.h"
#include "testing/devices/arm/TwoDiyRig.h"
#include "testing/devices/hid/FakeHidBus.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

using test::TwoDiyRig;

TEST(TwoDiyModel, HasThePlacesOfTheTableOfFacts)
{
  constexpr double deg = std::numbers::pi / 180.0;
  const test::TwoDiyModel model;
  EXPECT_LT((model.tipOf({ 140 * deg, 40 * deg, 0 }) - Vec3(0.01, 0.08280392, 0)).norm(), 1e-8);
  EXPECT_LT((model.tipOf({ 170 * deg, 60 * deg, 0 }) - Vec3(-0.01894242, 0.07178576, 0)).norm(), 1e-8);
  EXPECT_LT((model.tipOf({ 120 * deg, 10 * deg, 0 }) - Vec3(0.03894242, 0.07178576, 0)).norm(), 1e-8);
}

/// A message that was cut short stands before the guard's: the greeting of a board that pushes already, or torques.
TEST(TwoDiy, GuardEndsItsTorqueWhateverWasCutShort)
{
  const TwoDiyWire wire(boardOf(twoDiyArm()));
  WireOrder order;
  order.joint_Nm = { 0.07, -0.05, 0.0 };
  WireBytes push, anew = wire.greeting();
  wire.encode(order, push);
  anew.insert(anew.end(), push.begin(), push.end());
  for (const WireBytes& message : { push, anew })
  {
    for (std::size_t sent = 0; sent <= message.size(); ++sent)
    {
      test::TwoDiyModel model;
      model.take(wire.greeting());
      model.take(push);
      ASSERT_GT(model.torque_Nm[0], 0.06);
      model.take({ message.data(), sent });
      model.take(wire.farewell());
      EXPECT_EQ(model.torque_Nm, (std::array<double, 2>{})) << sent << " of " << message.size() << " bytes";
    }
  }
}

TEST(TwoDiy, BeginsItsAnglesInThePoseInWhichThePersonPresses)
{
  TwoDiyRig diy;
  diy.model->place({ 2.0, 0.5, 0.0 });
  ASSERT_EQ(diy.rig.device.open(), "");
  ask(diy.rig, { 0.5, 0.0, 0.0 });
  EXPECT_EQ(diy.rig.status, DeviceStatus::Waiting);
  EXPECT_EQ(diy.model->force_N().norm(), 0.0);
  ASSERT_TRUE(diy.rig.device.step());
  EXPECT_THAT(diy.rig.device.step()->sentence, testing::HasSubstr("stretched out"));
  diy.model->place({ std::numbers::pi, 0.0, 0.0 });
  diy.setInPose();
  EXPECT_EQ(diy.model->setUps, 2) << "once to be heard, once in the pose";
  EXPECT_EQ(diy.rig.status, DeviceStatus::Ok);
  EXPECT_FALSE(diy.rig.device.step());
  EXPECT_EQ(diy.rig.device.info().deviceClass, DeviceClass::Joystick2D) << "it gets what sticks with two axes get";
}

TEST(TwoDiy, AppliesTheForceThatIsAskedToAStepOfItsTorque)
{
  TwoDiyRig diy;
  ASSERT_EQ(diy.rig.device.open(), "");
  diy.setInPose();
  ask(diy.rig, Vec3::Zero());
  test::Random random(11);
  for (int i = 0; i < 300; ++i)
  {
    Vec3 from_m = 0.024 * random.direction();
    from_m.z() = 0.0;
    ASSERT_TRUE(diy.model->lead(from_m + Vec3(0.01, 0.085, 0.0)));
    Vec3 force_N = random.direction();
    force_N.z() = 0.0;
    diy.rig.command.wrench_D.force = force_N;
    diy.rig.run(4);
    ASSERT_EQ(diy.rig.status, DeviceStatus::Ok);
    constexpr double count_m = 1e-4; // 0.026 degrees of 50 mm, twice, and as far as the forearms stretch it
    EXPECT_LT((diy.rig.sample.pose_D.p - from_m).norm(), count_m);
    EXPECT_LT((diy.model->force_N() - force_N).norm(), diy.model->step_N() + 5e-3) << from_m.transpose();
  }
}

TEST(TwoDiy, IsNoWheelWhateverThePersonSays)
{
  const HidEntry entry{ "/dev/none", 0x2341, 0x003E, "7", "board" };
  const auto bus = std::make_shared<ListedArmBus>(ListedArmBus::Ways{ [entry] { return std::vector{ entry }; },
    [](const HidEntry&) { return ArmBus::Opened{}; }, [](const HidEntry&) { return ""; } });
  DeviceOptions options;
  options.hid = std::make_shared<test::FakeHidBus>();
  options.arms =
    std::make_shared<const std::vector<ArmKit>>(std::vector<ArmKit>{ { "2diy", bus, setupOf(twoDiyArm()) } });
  const std::string name = "2diy-2341-003e-7";
  EXPECT_EQ(makeDevice(name, options).device->info().deviceClass, DeviceClass::Joystick2D);
  options.wheel = true;
  const MadeDevice made = makeDevice(name, options);
  EXPECT_EQ(made.device, nullptr);
  EXPECT_EQ(made.problem, name + ": " + armIsNoWheel);
}

TEST(TwoDiy, IsToldNoTorqueBeforeItIsLetGo)
{
  TwoDiyRig diy;
  ASSERT_EQ(diy.rig.device.open(), "");
  diy.setInPose();
  diy.model->lead({ 0.01, 0.085, 0.0 });
  ask(diy.rig, { 0.5, 0.5, 0.0 });
  ASSERT_GT(diy.model->force_N().norm(), 0.6);
  diy.rig.device.close();
  EXPECT_EQ(diy.model->force_N().norm(), 0.0);
}

} // namespace
} // namespace palpate
