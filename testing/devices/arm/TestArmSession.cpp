// SPDX-License-Identifier: GPL-3.0-or-later
// Touching with each arm, in virtual time, through the whole loop: the force that the hand gets is the one that the
// session asked for, to a step of the motors' numbers, and none soon after the arm gives no reading any more.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "devices/common/LinkNotes.h"
#include "haptics/safety/SafetyLimits.h"
#include "haptics/session/HapticSession.h"
#include "haptics/session/LoopReport.h"
#include "haptics/session/Warning.h"
#include "testing/devices/arm/SessionArms.h"
#include "testing/support/Meshes.h"

namespace palpate
{
namespace
{

constexpr double ball_m = 0.012;
constexpr int minute_ms = 60000;

/// Where the hand is led: around the ball, into it so deep and out again twice a second [m].
struct Led
{
  double press_m = 0.002;

  [[nodiscard]] Vec3 at(double time_s, bool inPlane) const
  {
    const double turn = 2.0 * std::numbers::pi * 0.05 * time_s, tilt = inPlane ? 0.0 : 0.6 * std::sin(1.3 * turn);
    const double out_m = ball_m + this->press_m * std::sin(2.0 * std::numbers::pi * 2.0 * time_s);
    return out_m * Vec3(std::cos(turn) * std::cos(tilt), std::sin(turn) * std::cos(tilt), std::sin(tilt));
  }
};

/// Observations of the forces.
struct Seen
{
  int pushing = 0, beyond = 0, stalls = 0;
  double worst_N = 0.0;
  Vec3 asked_N = Vec3::Zero(); ///< in the last tick
  bool stuck = false;          ///< set by a test: the hand is measured where it was last
};

/// An arm whose exchange belongs to the tick.
class InTickDevice final : public HapticDevice
{
public:
  InTickDevice(test::SessionArm& arm, Seen& seen, const Led& led) : arm_(arm), seen_(seen), led_(led) {}

  [[nodiscard]] const DeviceInfo& info() const noexcept override { return this->arm_.device().info(); }
  [[nodiscard]] std::string open() override { return {}; }
  void close() noexcept override {}
  [[nodiscard]] DeviceStatus read(double time_s, DeviceSample& sample) noexcept override
  {
    if (!this->seen_.stuck)
    {
      this->arm_.lead(this->led_.at(time_s, this->arm_.inPlane()));
    }
    const bool inTime = this->arm_.pass();
    this->judge(inTime);
    return this->arm_.device().read(time_s, sample);
  }
  void write(const DeviceCommand& command) noexcept override
  {
    Vec3& asked_N = this->seen_.asked_N;
    asked_N = command.wrench_D.force;
    asked_N.z() = this->arm_.inPlane() ? 0.0 : asked_N.z();
    this->arm_.device().write(command);
  }

private:
  void judge(bool inTime)
  {
    const Vec3 force_N = this->arm_.force_N();
    const bool ended = !inTime && force_N.norm() == 0.0;
    const double off_N = ended ? 0.0 : (force_N - this->seen_.asked_N).norm();
    this->seen_.stalls += inTime ? 0 : 1;
    this->seen_.pushing += !ended && this->seen_.asked_N.norm() > 0.2 ? 1 : 0;
    const double ofThePlace_N = this->arm_.ofThePlace() * this->seen_.asked_N.norm();
    const bool beyond = off_N > ofThePlace_N && off_N > ofThePlace_N + this->arm_.step_N(); // a step takes long to find
    this->seen_.beyond += beyond ? 1 : 0;
    this->seen_.worst_N = std::max(this->seen_.worst_N, off_N);
  }

  test::SessionArm& arm_;
  Seen& seen_;
  Led led_;
};

/// A session in which an arm of that kind touches the ball.
template<class Arm>
struct Touching
{
  [[nodiscard]] std::string begin(const Led& led = {})
  {
    SessionOptions options;
    options.virtualTime = true;
    this->session.setScene(test::sceneOf(test::makeIcosphere(3, ball_m)));
    HapticParameters parameters = this->session.parameters();
    parameters.map = {};
    parameters.safety = SafetyLimits::forDevice(this->arm.device().info()); // as a person's session has them
    EXPECT_EQ(this->session.setParameters(parameters), "");
    std::string problem = this->arm.open();
    return !problem.empty() ? problem
                            : this->session.start(std::make_unique<InTickDevice>(this->arm, this->seen, led), options);
  }
  /// Touches until more than that is asked for. False: it never is.
  [[nodiscard]] bool pushes(double force_N)
  {
    for (int i = 0; i < minute_ms / 10 && this->seen.asked_N.norm() <= force_N; ++i)
    {
      EXPECT_EQ(this->session.step(1), 1);
    }
    return this->seen.asked_N.norm() > force_N;
  }
  /// Goes on until the session gives a reason for no force. How long that took, in ticks and by the arm's clock [ms].
  [[nodiscard]] double untilFault()
  {
    constexpr int most = 100;
    const std::int64_t from_ns = this->arm.clock().now_ns();
    int ticks = 0;
    while (ticks < most && this->session.state().fault == Fault::None)
    {
      ticks += this->session.step(1);
    }
    const std::int64_t took_ns = this->arm.clock().now_ns() - from_ns;
    return std::max(static_cast<double>(ticks), static_cast<double>(took_ns) / perMs_ns);
  }

  Arm arm;
  Seen seen;
  HapticSession session;
};

template<class Arm>
class ArmSession : public testing::Test
{
};
TYPED_TEST_SUITE(ArmSession, test::SessionArms);

TYPED_TEST(ArmSession, AppliesTheForceThatIsAskedForAMinute)
{
  Touching<TypeParam> touching;
  ASSERT_EQ(touching.begin(), "");
  ASSERT_EQ(touching.session.step(minute_ms), minute_ms);
  EXPECT_EQ(touching.session.state().fault, Fault::None);
  const Seen& seen = touching.seen;
  EXPECT_EQ(seen.beyond, 0) << "worst " << seen.worst_N << " N";
  EXPECT_GT(seen.pushing, minute_ms / 5) << seen.stalls << " stalls of this computer";
  EXPECT_EQ(touching.session.stop(), "");
}

/// A hand that holds still looks the same, so no fault comes of it.
TYPED_TEST(ArmSession, ThatRepeatsItsReadingUnderForceIsSaidAfterAQuarterOfASecondAndPushesOn)
{
  Touching<TypeParam> touching;
  ASSERT_EQ(touching.begin({ 0.008 }), "");
  HapticSession& session = touching.session;
  ASSERT_TRUE(touching.pushes(0.25 * touching.arm.device().info().maxForce_N.value));
  touching.seen.stuck = true;
  ASSERT_EQ(session.step(245), 245);
  EXPECT_EQ(warning(session.state(), session.report()), "");
  ASSERT_EQ(session.step(15), 15);
  EXPECT_THAT(warning(session.state(), session.report()), testing::HasSubstr("if the handle moved, check the device"));
  EXPECT_EQ(session.state().fault, Fault::None);
  EXPECT_EQ(touching.seen.beyond, 0);
  EXPECT_GT(touching.arm.force_N().norm(), 0.2);
  touching.seen.stuck = false;
  ASSERT_EQ(session.step(5), 5);
  EXPECT_EQ(warning(session.state(), session.report()), "");
}

constexpr double silent_ms = 20.0; ///< by when there is no force

template<class Arm>
class SilentArmSession : public testing::Test
{
};
TYPED_TEST_SUITE(SilentArmSession, test::SessionArms);

TYPED_TEST(SilentArmSession, HasNoForceWithinTwentyMillisecondsAndOneReasonUntilAPersonEngages)
{
  Touching<TypeParam> touching;
  ASSERT_EQ(touching.begin(), "");
  ASSERT_TRUE(touching.pushes(0.3));
  touching.arm.fallSilent();
  EXPECT_LE(touching.untilFault(), silent_ms);
  EXPECT_EQ(touching.session.state().fault, Fault::DeviceLost);
  for (int i = 0; i < 100; ++i)
  {
    ASSERT_EQ(touching.seen.asked_N.norm(), 0.0) << i;
    ASSERT_EQ(touching.arm.force_N().norm(), 0.0) << i;
    ASSERT_EQ(touching.session.step(1), 1);
  }
  const LinkReport link = touching.arm.device().linkReport();
  EXPECT_THAT(link.lostFor, testing::EndsWith(touching.arm.silence()));
  EXPECT_THAT(describeFault(Fault::DeviceLost, link), testing::HasSubstr(touching.arm.silence()));
}

template<class Arm>
class LibraryArmSession : public testing::Test
{
};
using LibraryArms = testing::Types<test::ForceDimensionArm, test::OpenHapticsArm>;
TYPED_TEST_SUITE(LibraryArmSession, LibraryArms);

TYPED_TEST(LibraryArmSession, OfNumbersThatNoHandHasHasNoForceWithinTwentyMillisecondsAndOneReason)
{
  using Number = test::LibraryArm::Number;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), endless = std::numeric_limits<double>::infinity();
  for (const Number which : { Number::Place, Number::Speed, Number::Turn })
  {
    for (const double number : { nan, endless, -endless, 1e300, -1e300, 1000.0 })
    {
      SCOPED_TRACE(testing::Message() << static_cast<int>(which) << " is " << number);
      Touching<TypeParam> touching;
      ASSERT_EQ(touching.begin(), "");
      ASSERT_TRUE(touching.pushes(0.3));
      touching.seen.stuck = true;
      touching.arm.report(which, number);
      EXPECT_LE(touching.untilFault(), silent_ms);
      EXPECT_EQ(touching.session.state().fault, Fault::DeviceLost);
      for (int i = 0; i < 100; ++i)
      {
        ASSERT_EQ(touching.seen.asked_N.norm(), 0.0) << i;
        ASSERT_EQ(touching.arm.force_N().norm(), 0.0) << i;
        ASSERT_EQ(touching.session.step(1), 1);
      }
      const LinkReport link = touching.arm.device().linkReport();
      EXPECT_EQ(link.lostFor, "the vendor's library reports a position, a speed or a turn that no hand has");
      EXPECT_THAT(describeFault(Fault::DeviceLost, link), testing::HasSubstr(link.lostFor));
    }
  }
}

// A single such answer costs a moment of force, as a late one does.
TYPED_TEST(LibraryArmSession, PushesNothingForTheAnswerAfterNumbersThatNoHandHas)
{
  Touching<TypeParam> touching;
  ASSERT_EQ(touching.begin(), "");
  ASSERT_TRUE(touching.pushes(0.3));
  touching.seen.stuck = true;
  touching.arm.report(test::LibraryArm::Number::Place, 1e300);
  ASSERT_EQ(touching.session.step(3), 3); // a call of the vendor's belongs to the exchange before
  EXPECT_EQ(touching.arm.force_N().norm(), 0.0);
  touching.seen.stuck = false;
  ASSERT_EQ(touching.session.step(5), 5);
  EXPECT_EQ(touching.session.state().fault, Fault::None);
  EXPECT_EQ(touching.arm.device().linkReport().losses, 0U);
}

TEST(GrippedArmSession, PushesOnlyWhileItsGripperIsHeldWhereTheGripIsTheDeadMansSwitch)
{
  constexpr double open_rad = 0.4, closed_rad = 0.1;
  Touching<test::ForceDimensionArm> touching;
  ASSERT_EQ(touching.begin(), "");
  HapticParameters parameters = touching.session.parameters();
  parameters.safety.deadMan.grip = true;
  ASSERT_EQ(touching.session.setParameters(parameters), "");
  const auto pushesIn = [&touching](int duration_ms)
  {
    int pushing = 0;
    for (int i = 0; i < duration_ms; ++i)
    {
      EXPECT_EQ(touching.session.step(1), 1);
      pushing += touching.seen.asked_N.norm() > 0.0 ? 1 : 0;
    }
    return pushing;
  };
  constexpr int twoPresses_ms = 1000, letGo_ms = 60;
  EXPECT_EQ(pushesIn(twoPresses_ms), 0) << "it has no gripper";
  touching.arm.openGripper(closed_rad);
  EXPECT_EQ(pushesIn(twoPresses_ms), 0) << "it has not been opened yet";
  touching.arm.openGripper(open_rad);
  EXPECT_EQ(pushesIn(twoPresses_ms), 0);
  touching.arm.openGripper(closed_rad);
  EXPECT_TRUE(touching.pushes(0.3));
  touching.arm.openGripper(open_rad);
  static_cast<void>(pushesIn(letGo_ms));
  EXPECT_EQ(pushesIn(twoPresses_ms), 0);
}

/// The library's own watchdog ends the force of a call that hangs; it goes on with none.
TEST(HangingArmSession, AsksForNoForceWithinTwentyMillisecondsAndGivesNoneWhenTheCallGoesOn)
{
  Touching<test::HangingArm> touching;
  ASSERT_EQ(touching.begin(), "");
  ASSERT_TRUE(touching.pushes(0.3));
  ASSERT_TRUE(touching.arm.hang());
  EXPECT_LE(touching.untilFault(), silent_ms);
  EXPECT_EQ(touching.session.state().fault, Fault::DeviceLost);
  EXPECT_EQ(touching.seen.asked_N.norm(), 0.0);
  EXPECT_EQ(describeFault(Fault::DeviceLost, touching.arm.device().linkReport()), describe(Fault::DeviceLost));
  ASSERT_EQ(touching.session.step(60), 60);
  EXPECT_EQ(touching.arm.device().linkReport().message, "the link to the device hangs");
  touching.arm.goOn();
  EXPECT_TRUE(test::eventually([&] { return touching.arm.force_N().norm() == 0.0; }));
}

} // namespace
} // namespace palpate
