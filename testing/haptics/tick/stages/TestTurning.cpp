// SPDX-License-Identifier: GPL-3.0-or-later
// Torque on its way to the hand, its work, and the pose that a device is drawn to.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include <gtest/gtest.h>

#include "haptics/session/HapticSession.h"
#include "haptics/tick/TickContext.h"
#include "testing/haptics/tick/stages/Tick.h"
#include "testing/support/BareDevice.h"
#include "testing/support/Meshes.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

using test::dt_s;

constexpr double known_Nm = 0.5;

DeviceInfo turningInfo()
{
  DeviceInfo info;
  info.deviceClass = DeviceClass::Rigid6D;
  info.rendersTorque = true;
  info.maxTorque_Nm = { known_Nm, true };
  info.maxForce_N = { 5.0, true };
  return info;
}

/// A hand that force is let through to, and a stage before the limits that asks for a torque.
class Turning : public testing::Test
{
protected:
  Turning()
  {
    this->parameters_.safety = SafetyLimits::forDevice(turningInfo());
    this->state_.gain = 1.0;
  }

  HapticState turn(const Vec3& rendered_D, const Quat& hand = Quat::Identity())
  {
    TickInput input;
    input.dt_s = dt_s;
    input.sample.pose_D.q = hand;
    TickOutput out;
    TickContext tick{ input, this->parameters_, this->state_, out };
    stage::Hand::step(tick);
    out.state.renderedTorque_D = rendered_D;
    stage::Protect::step(tick);
    EXPECT_EQ(out.command.wrench_D.torque, out.state.torque_D);
    return out.state;
  }

  HapticParameters parameters_;
  RendererState state_;
};

TEST_F(Turning, IsLimitedToSixTenthsOfWhatTheDeviceCanAndGrowsToAllOfThatInTwelveMilliseconds)
{
  const Vec3 axis = Vec3(1, -2, 2) / 3.0;
  const double largest_Nm = 0.6 * known_Nm, rise_Nm = 50.0 * known_Nm * dt_s;
  for (int i = 1; i <= 20; ++i)
  {
    const HapticState state = this->turn(2.0 * known_Nm * axis);
    EXPECT_LT((state.torque_D - std::min(largest_Nm, i * rise_Nm) * axis).norm(), 1e-12) << i;
    EXPECT_TRUE(state.clamped);
    EXPECT_EQ(state.riseLimited, i * rise_Nm < largest_Nm - 1e-12) << i;
  }
  EXPECT_EQ(this->turn(Vec3::Zero()).torque_D, Vec3(Vec3::Zero())) << "release is free";
}

TEST_F(Turning, GoesThroughTheRampOfTheForce)
{
  this->parameters_.safety.maxTorqueRise_Nm_per_s = std::numeric_limits<double>::infinity();
  const Vec3 wanted_D(0.0, 0.1, 0.0);
  for (const double gain : { 0.0, 0.25, 0.5, 1.0 })
  {
    this->state_.gain = gain;
    const double share = gain * gain * (3.0 - 2.0 * gain);
    EXPECT_LT((this->turn(wanted_D).torque_D - share * wanted_D).norm(), 1e-15) << gain;
  }
}

TEST_F(Turning, IsNoneForADeviceThatGivesNone)
{
  DeviceInfo info = turningInfo();
  info.rendersTorque = false;
  this->parameters_.safety = SafetyLimits::forDevice(info);
  EXPECT_EQ(this->turn(Vec3(0, 0, 1)).torque_D, Vec3(Vec3::Zero()));
}

TEST_F(Turning, OfADeviceWhoseLargestTorqueNobodyKnowsIsThatOfTheUnknownForceOnAnArmOf30Millimetres)
{
  DeviceInfo info = turningInfo();
  info.maxTorque_Nm = DeviceInfo().maxTorque_Nm;
  const SafetyLimits limits = SafetyLimits::forDevice(info), unknown;
  EXPECT_NEAR(limits.maxTorque_Nm, unknown.maxForce_N * 0.03, 1e-15);
  EXPECT_GE(limits.maxTorque_Nm / limits.maxTorqueRise_Nm_per_s, 0.01) << "reached in no less than 10 ms";
}

TEST_F(Turning, ThatIsNoNumberIsNoneAndEndsTheForce)
{
  EXPECT_EQ(this->turn(Vec3(0, std::nan(""), 0)).torque_D, Vec3(Vec3::Zero()));
  EXPECT_EQ(this->state_.fault, Fault::NonFiniteSample);
}

TEST_F(Turning, MetersWhatTheTorqueDidOverEachTurnOfTheHand)
{
  this->parameters_.safety.maxTorqueRise_Nm_per_s = std::numeric_limits<double>::infinity();
  const Vec3 axis = Vec3(2, 1, -2) / 3.0;
  constexpr double torque_Nm = 0.2, turn_rad = 0.01;
  constexpr int there = 100, back = 40;
  const auto at = [&](double angle_rad) { return Quat(Eigen::AngleAxisd(angle_rad, axis)); };
  this->turn(torque_Nm * axis, at(0.0));
  for (int i = 1; i <= there; ++i)
  {
    // Of each turn the meter takes 2 sin(half of it), which is less by its cube / 24.
    EXPECT_NEAR(this->turn(torque_Nm * axis, at(i * turn_rad)).turned_J, i * torque_Nm * turn_rad,
      i * torque_Nm * std::pow(turn_rad, 3) / 20.0);
  }
  HapticState last;
  for (int i = 1; i <= back; ++i)
  {
    const Quat hand = at((there - i) * turn_rad);
    last = this->turn(torque_Nm * axis, Quat(-hand.w(), -hand.x(), -hand.y(), -hand.z())); // the same rotation
  }
  EXPECT_NEAR(last.turned_J, (there - back) * torque_Nm * turn_rad, 1e-5 * torque_Nm);
}

/// Hands each command to a test.
class TurningDevice final : public test::BareDevice
{
public:
  TurningDevice(const Vec3& p_D, DeviceCommand& told) : BareDevice("turning", true), p_D_(p_D), told_(told)
  {
    this->turning_ = turningInfo();
    this->turning_.simulated = true;
  }
  [[nodiscard]] const DeviceInfo& info() const noexcept override { return this->turning_; }
  [[nodiscard]] DeviceStatus read(double tickTime_s, DeviceSample& sample) noexcept override
  {
    sample = {};
    sample.time_s = tickTime_s;
    sample.pose_D.p = this->p_D_ - Vec3(0, 0, std::max(0.0, tickTime_s - 2.0) * 0.05); // comes down after 2 s
    sample.pose_D.q = Quat(0.6, 0.0, 0.8, 0.0);
    this->hand_ = sample.pose_D;
    return DeviceStatus::Ok;
  }
  void write(const DeviceCommand& command) noexcept override
  {
    this->told_ = command;
    if (command.target.stiffness_N_per_m > 0.0)
    {
      // The device's own spring gives the force of the command.
      const Vec3 spring_N = command.target.stiffness_N_per_m * (command.target.pose_D.p - this->hand_.p);
      EXPECT_LT((spring_N - command.wrench_D.force).norm(), 1e-9);
      EXPECT_EQ(command.target.pose_D.q.coeffs(), this->hand_.q.coeffs());
    }
  }

private:
  DeviceInfo turning_;
  Vec3 p_D_;
  Pose hand_;
  DeviceCommand& told_;
};

TEST_F(Turning, ADeviceThatClosesTheSpringItselfIsDrawnToWhereItGivesTheLimitedForce)
{
  test::Random random(test::testSeed(1402));
  DeviceCommand told;
  HapticSession session;
  SessionOptions options;
  options.virtualTime = true;
  this->parameters_.stiffness_N_per_m = 1000.0;
  this->parameters_.map = {};
  ASSERT_EQ(session.setParameters(this->parameters_), "");
  session.setScene(test::sceneOf(test::makeSheet({ 2.0, 2.0, 8, 8, 0.2 }, random)));
  ASSERT_EQ(session.start(std::make_unique<TurningDevice>(Vec3(0, 0, 1e-3), told), options), "");
  ASSERT_EQ(session.step(10), 10);
  EXPECT_EQ(told.target.pose_D.p, Vec3(0, 0, 1e-3)) << "nothing touched";
  session.engage();
  ASSERT_EQ(session.step(2400), 2400);
  EXPECT_TRUE(session.state().clamped) << "some 20 mm of wall are more than 3 N";
  EXPECT_NEAR(told.wrench_D.force.z(), this->parameters_.safety.maxForce_N, 1e-9);
  EXPECT_GT(told.target.stiffness_N_per_m, 0.0);
  EXPECT_LT(told.target.pose_D.p.z(), session.state().proxy_W.p.z())
    << "nearer than the proxy, for the force is limited";
  EXPECT_EQ(told.wrench_D.torque, Vec3(Vec3::Zero())) << "nobody asked for one";
  EXPECT_EQ(session.stop(), "");
  EXPECT_EQ(told.target.stiffness_N_per_m, 0.0) << "nothing draws a hand that nobody leads";
}

} // namespace
} // namespace palpate
