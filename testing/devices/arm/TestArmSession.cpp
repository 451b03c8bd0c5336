// SPDX-License-Identifier: GPL-3.0-or-later
// A minute of touching with each arm, in virtual time, through the whole loop: the force that the hand gets is the one
// that the session asked for, to a step of the motors' numbers.
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

#include "haptics/safety/SafetyLimits.h"
#include "haptics/session/HapticSession.h"
#include "testing/devices/arm/SessionArms.h"
#include "testing/support/Meshes.h"

namespace palpate
{
namespace
{

constexpr double ball_m = 0.012, press_m = 0.002;
constexpr int minute_ms = 60000;

/// Where the hand is led: around the ball, into it and out again twice a second [m].
Vec3 ledTo(double time_s, bool inPlane)
{
  const double turn = 2.0 * std::numbers::pi * 0.05 * time_s, tilt = inPlane ? 0.0 : 0.6 * std::sin(1.3 * turn);
  const double out_m = ball_m + press_m * std::sin(2.0 * std::numbers::pi * 2.0 * time_s);
  return out_m * Vec3(std::cos(turn) * std::cos(tilt), std::sin(turn) * std::cos(tilt), std::sin(tilt));
}

/// Observations of the forces.
struct Seen
{
  int ticks = 0, pushing = 0, beyond = 0, stalls = 0;
  double worst_N = 0.0;
};

/// An arm whose exchange belongs to the tick.
class InTickDevice final : public HapticDevice
{
public:
  InTickDevice(test::SessionArm& arm, Seen& seen) : arm_(arm), seen_(seen) {}

  [[nodiscard]] const DeviceInfo& info() const noexcept override { return this->arm_.device().info(); }
  [[nodiscard]] std::string open() override { return {}; }
  void close() noexcept override {}
  [[nodiscard]] DeviceStatus read(double time_s, DeviceSample& sample) noexcept override
  {
    this->arm_.lead(ledTo(time_s, this->arm_.inPlane()));
    const bool inTime = this->arm_.pass();
    this->judge(inTime);
    return this->arm_.device().read(time_s, sample);
  }
  void write(const DeviceCommand& command) noexcept override
  {
    this->asked_N_ = command.wrench_D.force;
    this->asked_N_.z() = this->arm_.inPlane() ? 0.0 : this->asked_N_.z();
    this->arm_.device().write(command);
  }

private:
  void judge(bool inTime)
  {
    const Vec3 force_N = this->arm_.force_N();
    const bool ended = !inTime && force_N.norm() == 0.0;
    const double off_N = ended ? 0.0 : (force_N - this->asked_N_).norm();
    ++this->seen_.ticks;
    this->seen_.stalls += inTime ? 0 : 1;
    this->seen_.pushing += !ended && this->asked_N_.norm() > 0.2 ? 1 : 0;
    const double ofThePlace_N = this->arm_.ofThePlace() * this->asked_N_.norm();
    const bool beyond = off_N > ofThePlace_N && off_N > ofThePlace_N + this->arm_.step_N(); // a step takes long to find
    this->seen_.beyond += beyond ? 1 : 0;
    this->seen_.worst_N = std::max(this->seen_.worst_N, off_N);
  }

  test::SessionArm& arm_;
  Seen& seen_;
  Vec3 asked_N_ = Vec3::Zero();
};

template<class Arm>
class ArmSession : public testing::Test
{
};
using SessionArms = testing::Types<test::WoodenHapticsArm, test::FalconArm, test::TwoDiyArm, test::HaplyArm,
  test::ForceDimensionArm, test::OpenHapticsArm>;
TYPED_TEST_SUITE(ArmSession, SessionArms);

TYPED_TEST(ArmSession, AppliesTheForceThatIsAskedForAMinute)
{
  TypeParam arm;
  ASSERT_EQ(arm.open(), "");
  Seen seen;
  HapticSession session;
  SessionOptions options;
  options.virtualTime = true;
  session.setScene(test::sceneOf(test::makeIcosphere(3, ball_m)));
  HapticParameters parameters = session.parameters();
  parameters.map = {};
  parameters.safety = SafetyLimits::forDevice(arm.device().info()); // as a person's session has them
  ASSERT_EQ(session.setParameters(parameters), "");
  ASSERT_EQ(session.start(std::make_unique<InTickDevice>(arm, seen), options), "");
  ASSERT_EQ(session.step(minute_ms), minute_ms);
  EXPECT_EQ(session.state().fault, Fault::None);
  EXPECT_EQ(seen.beyond, 0) << "worst " << seen.worst_N << " N";
  EXPECT_GT(seen.pushing, minute_ms / 5) << seen.stalls << " stalls of this computer";
  EXPECT_EQ(session.stop(), "");
}

} // namespace
} // namespace palpate
