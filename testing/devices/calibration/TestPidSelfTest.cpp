// SPDX-License-Identifier: GPL-3.0-or-later
// The self-test through the whole of a USB link: descriptors, reports, effects that the firmware runs.
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "devices/calibration/SelfTestFindings.h"
#include "testing/devices/hid/PidRig.h"

namespace palpate
{
namespace
{

using test::PidLayout;
using test::PidRig;

/// A resting hand, in what the firmware counts in: half travels, the device's largest force, HID's axes.
constexpr double limpHand = 4.0, restingHand = 8.0, pace = 2e-3;

struct Outcome
{
  SelfTestPlan plan;
  SelfTestState state;
  PidScale scale;

  [[nodiscard]] std::string text() const { return resultOf(this->plan, this->state); }
};

Outcome check(const PidLayout& layout, double handStiffness, double motorSign)
{
  constexpr int longest_ms = 100'000;
  PidRig rig(layout);
  EXPECT_EQ(rig.device.open(), "");
  rig.run(5);
  Outcome outcome{ SelfTestPlan::forDevice(rig.device.info()), {}, rig.scale() };
  Vec3 hand = Vec3::Zero();
  for (int ms = 0; ms < longest_ms && outcome.state.verdict == SelfTestVerdict::None; ++ms)
  {
    const Vec3 asked = askedPlace_D(outcome.plan, outcome.state) / outcome.scale.halfTravel_m;
    hand += (asked - hand).cwiseMax(-pace).cwiseMin(pace);
    const auto& at = rig.stick().position;
    rig.stick().push = { handStiffness * (hand.x() - at[0]), handStiffness * (-hand.y() - at[1]) };
    rig.run(1);
    rig.command = stepSelfTest(outcome.plan, rig.sample, rig.status, 1e-3, outcome.state);
    rig.command.wrench_D.force *= motorSign;
  }
  EXPECT_EQ(rig.stick().badReports, 0) << layout.name;
  return outcome;
}

TEST(PidSelfTest, FindsEveryLayoutAsItIs)
{
  for (const PidLayout& layout : test::allLayouts())
  {
    const Outcome found = check(layout, restingHand, 1.0);
    ASSERT_EQ(found.state.verdict, SelfTestVerdict::Passed) << layout.name << ": " << found.text();
    const double given_m_per_N = found.scale.halfTravel_m / (restingHand * found.scale.maxForce_N);
    for (int axis = 0; axis < 2; ++axis)
    {
      const AxisFinding range = findAxis(found.plan, found.state, axis);
      const MotorFinding motor = findMotor(found.plan, found.state, axis);
      EXPECT_EQ(std::pair(range.sensor, range.sign), std::pair(axis, 1)) << layout.name;
      EXPECT_NEAR(range.high_m - range.low_m, 2.0 * found.scale.halfTravel_m, 2.0 * found.plan.resolution_m);
      EXPECT_EQ(std::pair(motor.sensor, motor.sign), std::pair(axis, 1)) << layout.name;
      // The handle's friction of 0.6 makes the hand lag by tau = 0.6 / 8 = 0.075 s: where a quarter of the way is
      // reached, t = 0.16 s, its slope is 1 - exp(-t / tau) = 0.88 of the true one, and nearer to it afterwards.
      EXPECT_GT(motor.response_m_per_N, 0.88 * given_m_per_N) << layout.name;
      EXPECT_LT(motor.response_m_per_N, 1.02 * given_m_per_N) << layout.name; // what rounding to steps may add
    }
  }
}

TEST(PidSelfTest, FindsAFirmwareThatTakesADirectionAsTheOneTheForceComesFrom)
{
  const Outcome found = check(test::plainLayout(), restingHand, -1.0);
  ASSERT_EQ(found.state.verdict, SelfTestVerdict::Passed) << found.text();
  for (int axis = 0; axis < 2; ++axis)
  {
    EXPECT_EQ(findAxis(found.plan, found.state, axis).sign, 1);
    EXPECT_EQ(findMotor(found.plan, found.state, axis).sign, -1);
  }
}

/// The handle of the firmware in a hand of that stiffness: what pushes do to it, without a link, steps or delays.
class Handle
{
public:
  explicit Handle(double stiffness) : stiffness_(stiffness) {}

  /// The slope of its way over the rising force, by least squares from a quarter of the way on.
  double push(double direction, double spring)
  {
    const double from = this->x_;
    std::vector<std::pair<double, double>> rise; // share of the force, way
    double end = 0.0;
    for (double t_s = 0.0; t_s < push::all_s; t_s += dt_s)
    {
      this->step(direction * push::share(t_s), spring, from);
      const double way = direction * (this->x_ - from);
      if (t_s < push::rise_s)
      {
        rise.emplace_back(push::share(t_s), way);
      }
      end = t_s < push::rise_s + 0.5 * push::stay_s ? way : end;
    }
    std::erase_if(rise, [end](const auto& at) { return at.second < 0.25 * end; });
    return slope(rise);
  }

  void rest(double duration_s, double spring)
  {
    const double from = this->x_;
    for (double t_s = 0.0; t_s < duration_s; t_s += dt_s)
    {
      this->step(0.0, spring, from);
    }
  }

private:
  static constexpr double dt_s = 2.5e-4;

  void step(double force, double spring, double centre)
  {
    using Stick = test::VirtualPidDevice;
    const double held = this->stiffness_ * this->x_ + spring * (this->x_ - centre);
    this->v_ += dt_s / Stick::handleMass * (force - held - Stick::handleFriction * this->v_);
    this->x_ += dt_s * this->v_;
  }

  static double slope(const std::vector<std::pair<double, double>>& points)
  {
    double n = 0.0, sumF = 0.0, sumX = 0.0, sumFF = 0.0, sumFX = 0.0;
    for (const auto& [F, x] : points)
    {
      n += 1.0;
      sumF += F;
      sumX += x;
      sumFF += F * F;
      sumFX += F * x;
    }
    return (n * sumFX - sumF * sumX) / (n * sumFF - sumF * sumF);
  }

  double stiffness_, x_ = 0.0, v_ = 0.0;
};

// The firmware's spring and its forces are on one scale, so the motor's strength would be 1 if the hand gave way at
// once. It lags, and a little still moves back from the push before: that much a handle by itself shows too. Delays of
// up to 4 ms in a rise of 400 leave each slope to 1 %, and each counts by its logarithmic derivative.
TEST(PidSelfTest, MeasuresTheMotorAgainstTheSpringThatTheFirmwareHolds)
{
  const Outcome found = check(test::plainLayout(), limpHand, 1.0);
  ASSERT_TRUE(found.plan.holdsWalls);
  const double k = found.plan.spring_N_per_m * found.scale.halfTravel_m / found.scale.maxForce_N;
  Handle handle(limpHand);
  const auto pair = [&handle](double settle_s, double brace_s, double spring)
  {
    double sum = 0.0;
    for (const double direction : { 1.0, -1.0 })
    {
      handle.rest(settle_s, 0.0);
      handle.rest(brace_s, spring);
      sum += handle.push(direction, spring);
    }
    return 0.5 * sum;
  };
  static_cast<void>(pair(0.25, 1.1, k));
  const double held = pair(0.25, 1.1, k), free = pair(0.25, 0.0, 0.0);
  const double expected = k * free * held / (free - held), off = 0.01 * (1.0 + 2.0 * limpHand / k);
  EXPECT_NEAR(findMotor(found.plan, found.state, 0).strength, expected, off);
  EXPECT_NEAR(findMotor(found.plan, found.state, 1).strength, expected, off);
}

} // namespace
} // namespace palpate
