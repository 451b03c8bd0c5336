// SPDX-License-Identifier: GPL-3.0-or-later
// A minute of touching with each arm, in virtual time, through the whole loop: the force that the hand gets is the one
// that the session asked for, to a step of the motors' numbers.
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

#include "devices/arm/kit/Kits.h"
#include "haptics/session/HapticSession.h"
#include "testing/devices/arm/FalconRig.h"
#include "testing/devices/arm/LibraryRig.h"
#include "testing/devices/arm/TwoDiyRig.h"
#include "testing/devices/arm/WoodenHapticsRig.h"
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

/// An arm whose exchange belongs to the tick, and the means to judge it.
struct ExchangedArm
{
  ArmDevice& device;
  std::function<void(const Vec3& from_m)> lead; ///< the hand, from the middle of the work space
  std::function<void()> pass;
  std::function<Vec3()> force_N;
  std::function<double()> step_N;
  bool inPlane = false;
};

/// Observations of the forces.
struct Seen
{
  int ticks = 0, pushing = 0, beyond = 0;
  double worst_N = 0.0;
};

class InTickDevice final : public HapticDevice
{
public:
  InTickDevice(ExchangedArm& arm, Seen& seen) : arm_(arm), seen_(seen) {}

  [[nodiscard]] const DeviceInfo& info() const noexcept override { return this->arm_.device.info(); }
  [[nodiscard]] std::string open() override { return {}; }
  void close() noexcept override {}
  [[nodiscard]] DeviceStatus read(double time_s, DeviceSample& sample) noexcept override
  {
    this->arm_.lead(ledTo(time_s, this->arm_.inPlane));
    this->arm_.pass();
    this->judge();
    return this->arm_.device.read(time_s, sample);
  }
  void write(const DeviceCommand& command) noexcept override
  {
    this->asked_N_ = command.wrench_D.force;
    this->asked_N_.z() = this->arm_.inPlane ? 0.0 : this->asked_N_.z();
    this->arm_.device.write(command);
  }

private:
  /// The Jacobian is that of the place of the exchange before, in whole counts.
  void judge()
  {
    constexpr double ofThePlace = 0.015;
    const double off_N = (this->arm_.force_N() - this->asked_N_).norm();
    ++this->seen_.ticks;
    this->seen_.pushing += this->asked_N_.norm() > 0.2 ? 1 : 0;
    this->seen_.beyond += off_N > this->arm_.step_N() + ofThePlace * this->asked_N_.norm() ? 1 : 0;
    this->seen_.worst_N = std::max(this->seen_.worst_N, off_N);
  }

  ExchangedArm& arm_;
  Seen& seen_;
  Vec3 asked_N_ = Vec3::Zero();
};

void expectAMinute(ExchangedArm arm)
{
  Seen seen;
  HapticSession session;
  SessionOptions options;
  options.virtualTime = true;
  session.setScene(test::sceneOf(test::makeIcosphere(3, ball_m)));
  HapticParameters parameters = session.parameters();
  parameters.map = {};
  ASSERT_EQ(session.setParameters(parameters), "");
  ASSERT_EQ(session.start(std::make_unique<InTickDevice>(arm, seen), options), "");
  ASSERT_EQ(session.step(minute_ms), minute_ms);
  EXPECT_EQ(session.state().fault, Fault::None);
  EXPECT_EQ(seen.beyond, 0) << "worst " << seen.worst_N << " N";
  EXPECT_GT(seen.pushing, minute_ms / 5);
  EXPECT_EQ(session.stop(), "");
}

TEST(ArmSession, AMinuteWithAWoodenHaptics)
{
  test::WoodenHapticsRig rig;
  ASSERT_EQ(rig.open(), "");
  expectAMinute({ rig.device, [&](const Vec3& from_m) { ASSERT_TRUE(rig.model->lead(from_m)); }, [&] { rig.pass(); },
    [&] { return rig.model->force_N(); }, [&] { return 2.0 * rig.model->halfStep_N(); } });
}

TEST(ArmSession, AMinuteWithAFalcon)
{
  test::FalconRig falcon;
  ASSERT_EQ(falcon.rig.device.open(), "");
  falcon.home();
  expectAMinute({ falcon.rig.device,
    [&](const Vec3& from_m) { falcon.model->place(test::FalconModel::anglesAt(from_m + Vec3(0.0, 0.0, 0.125))); },
    [&] { falcon.rig.pass(); }, [&] { return falcon.model->force_N(); }, [&] { return falcon.model->step_N(); } });
}

TEST(ArmSession, AMinuteWithATwoDiy)
{
  test::TwoDiyRig diy;
  ASSERT_EQ(diy.rig.device.open(), "");
  diy.setInPose();
  expectAMinute(
    { diy.rig.device, [&](const Vec3& from_m) { ASSERT_TRUE(diy.model->lead(from_m + Vec3(0.01, 0.085, 0.0))); },
      [&] { diy.rig.pass(); }, [&] { return diy.model->force_N(); }, [&] { return diy.model->step_N(); }, true });
}

TEST(ArmSession, AMinuteWithForceDimensionsLibrary)
{
  test::LibraryRig rig(forceDimensionKit(PALPATE_FAKE_DHD));
  ASSERT_EQ(rig.device.open(), "");
  const auto place = test::fakeFunction<void(double, double, double, double)>(PALPATE_FAKE_DHD, "fakePlace");
  const auto force = test::fakeFunction<double(int)>(PALPATE_FAKE_DHD, "fakeForce");
  expectAMinute({ rig.device, [&](const Vec3& from_m) { place(from_m.x(), from_m.y(), from_m.z(), 0.0); },
    [&]
    {
      ASSERT_TRUE(rig.device.link().pass());
      rig.time.pass(perMs_ns);
    },
    [&] { return Vec3(force(0), force(1), force(2)); }, [] { return 0.0; } });
  place(0.01, 0.02, -0.03, 0.1); // as other tests have it
}

} // namespace
} // namespace palpate
