// SPDX-License-Identifier: GPL-3.0-or-later
// Properties of every arm, against a line whose behaviour a test sets.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "devices/arm/ArmDevice.h"
#include "devices/arm/ListedArmBus.h"
#include "devices/arm/WireLine.h"
#include "devices/arm/protocol/FalconWire.h"
#include "devices/calibration/CalibratedDevice.h"
#include "devices/calibration/SelfTestRun.h"
#include "devices/common/LinkNotes.h"
#include "testing/devices/arm/ServoSide.h"
#include "testing/support/AllocationGuard.h"
#include "testing/support/Eventually.h"

namespace palpate
{
namespace
{

/// The behaviour of a line, and its last order.
struct Script
{
  test::ModelTime* time = nullptr; ///< null: the line answers at once
  std::int64_t takes_ns = perMs_ns / 4;
  WireOrder last;
  int missing = 0; ///< each so-manieth answer does not come; 0: all come
  int asked = 0;
  std::function<Vec3(const Vec3& force_N)> hand; ///< its place under that force; null: it stays in the middle
  std::atomic<bool> waits = false;               ///< for a step of a person
  std::string file;                              ///< that the person chose
};

class ScriptedLine final : public ArmLine
{
public:
  explicit ScriptedLine(std::shared_ptr<Script> script) : script_(std::move(script)) {}

  Answer exchange(const WireOrder& order, int /*timeout_ms*/) override
  {
    this->script_->last = order;
    if (this->script_->time != nullptr)
    {
      this->script_->time->pass(this->script_->takes_ns);
    }
    const bool misses = this->script_->missing > 0 && ++this->script_->asked % this->script_->missing == 0;
    Answer answer{ misses ? Said::Nothing : Said::Reading, {} };
    answer.reading.pose_D = Pose{};
    answer.reading.pose_D->p = this->script_->hand ? this->script_->hand(order.wrench_D.force) : Vec3(Vec3::Zero());
    return answer;
  }
  void letGo() noexcept override { this->script_->last = {}; }
  std::optional<DeviceStep> step() const override
  {
    return this->script_->waits ? std::optional(DeviceStep{ "Choose a file.", "Choose...", true }) : std::nullopt;
  }
  void stepDone(const std::string& file) override
  {
    this->script_->file = file;
    this->script_->waits = false;
  }
  std::string error() const override { return "an error of before"; }

private:
  std::shared_ptr<Script> script_;
};

ArmSetup turningSetup()
{
  ArmSetup setup;
  setup.what = "an arm that senses turns";
  setup.turns = true;
  setup.force_N = { 3.0, true };
  return setup;
}

std::shared_ptr<ArmBus> busOf(const std::shared_ptr<Script>& script, const HidEntry& entry)
{
  return std::make_shared<ListedArmBus>(ListedArmBus::Ways{ [entry] { return std::vector{ entry }; },
    [script](const HidEntry&) {
      return ArmBus::Opened{ std::make_unique<ScriptedLine>(script), {} };
    },
    [](const HidEntry&) { return ""; } });
}

/// Such an arm in virtual time; a tick, then an exchange of a millisecond or as long as the script says.
struct ScriptedRig : test::ServoSide
{
  ScriptedRig() { this->script->time = &this->time; }

  void run(int duration_ms)
  {
    for (int i = 0; i < duration_ms; ++i)
    {
      this->tick(this->device, this->time.now_ns());
      this->pass();
    }
  }
  void pass()
  {
    static_cast<void>(this->device.link().pass());
    this->time.pass(std::max<std::int64_t>(0, perMs_ns - this->script->takes_ns));
  }

  test::ModelTime time;
  std::shared_ptr<Script> script = std::make_shared<Script>();
  HidEntry entry{ "line", 1, 2, "7", "scripted" };
  ArmDevice device{ "arm", busOf(script, entry), entry, turningSetup(), { false, &time } };
};

TEST(ArmDevice, ReadsWritesAndAwaitsWithoutAllocationAndWithoutALock)
{
  const HidEntry entry{ "line", 1, 2, "7", "scripted" };
  ArmDevice device("arm", busOf(std::make_shared<Script>(), entry), entry, turningSetup());
  ASSERT_EQ(device.open(), "");
  DeviceSample sample;
  int tick = 0;
  ASSERT_TRUE(test::eventually([&] { return device.read(1e-3 * ++tick, sample) == DeviceStatus::Ok; }));
  DeviceCommand command;
  command.wrench_D.force = { 0.1, 0.0, 0.0 };
  const test::AllocationGuard guard;
  for (int i = 0; i < 200; ++i)
  {
    device.await();
    static_cast<void>(device.read(1e-3 * ++tick, sample));
    device.write(command);
  }
  EXPECT_EQ(guard.allocations(), 0U);
  EXPECT_EQ(guard.frees(), 0U);
  EXPECT_EQ(guard.locks(), 0U);
}

TEST(ArmDevice, IsPreparedByThePersonWhileItsCheckRuns)
{
  const HidEntry entry{ "line", 1, 2, "7", "scripted" };
  const auto script = std::make_shared<Script>();
  script->waits = true;
  SelfTestRun run;
  SelfTestOptions options;
  options.virtualTime = true;
  ASSERT_EQ(run.start(std::make_unique<ArmDevice>("arm", busOf(script, entry), entry, turningSetup()), options), "");
  ASSERT_TRUE(run.need());
  EXPECT_EQ(run.need()->sentence, "Choose a file.");
  run.needDone("firmware.bin");
  EXPECT_FALSE(run.need());
  EXPECT_EQ(script->file, "firmware.bin");
  run.stop();
  EXPECT_FALSE(run.need());
}

TEST(AnswerBell, IsHeardOnceHoweverOftenItRangAndAlsoIfItRangBefore)
{
  AnswerBell bell;
  bell.ring();
  bell.ring();
  EXPECT_TRUE(bell.await(std::chrono::seconds(100)));
  EXPECT_FALSE(bell.await(std::chrono::microseconds(0)));
  bell.ring();
  EXPECT_TRUE(bell.await(std::chrono::microseconds(0)));
}

TEST(AnswerBell, WakesAThreadThatWaits)
{
  AnswerBell bell;
  bool heard = false;
  std::thread servo([&] { heard = bell.await(std::chrono::seconds(100)); });
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  bell.ring();
  servo.join();
  EXPECT_TRUE(heard);
}

/// A link whose other end has let go of it.
class LeftLink final : public ByteLink
{
public:
  explicit LeftLink(bool sends) : sends_(sends) {}
  bool send(std::span<const std::uint8_t> /*bytes*/) noexcept override { return this->sends_; }
  int receive(std::span<std::uint8_t> /*bytes*/, int /*timeout_ms*/) noexcept override { return -1; }
  std::string error() const override { return "Broken pipe"; }
  std::string gone() const override { return "the other end left"; }
  std::string unsent() const override { return "the other end took nothing"; }
  bool keepsBorders() const noexcept override { return true; }

private:
  bool sends_;
};

TEST(WireLine, SaysOfAFailureWhatItsLinkSays)
{
  WireLine left(std::make_unique<LeftLink>(true), std::make_shared<FalconWire>());
  EXPECT_EQ(left.exchange({}, 1).said, ArmLine::Said::Gone);
  EXPECT_EQ(left.error(), "the other end left");
  WireLine full(std::make_unique<LeftLink>(false), std::make_shared<FalconWire>());
  EXPECT_EQ(full.exchange({}, 1).said, ArmLine::Said::Gone);
  EXPECT_EQ(full.error(), "the other end took nothing");
}

TEST(ArmDevice, GivesNoForceAfterAnAnswerThatCameTooLateAndForceAgainAfterOneInTime)
{
  for (const std::int64_t takes_ns : { ArmLink::answer_ms * perMs_ns + 1, ArmLink::silence_ns - perMs_ns })
  {
    ScriptedRig rig;
    ASSERT_EQ(rig.device.open(), "");
    ask(rig, { 0.5, 0.0, 0.0 });
    ASSERT_EQ(rig.script->last.wrench_D.force.x(), 0.5);
    rig.script->takes_ns = takes_ns;
    rig.run(1);
    EXPECT_EQ(rig.script->last.wrench_D.force.x(), 0.5) << "nobody knew yet";
    rig.script->takes_ns = perMs_ns / 4;
    rig.run(1);
    EXPECT_EQ(rig.script->last.wrench_D.force.norm(), 0.0) << takes_ns;
    rig.run(1);
    EXPECT_EQ(rig.script->last.wrench_D.force.x(), 0.5) << takes_ns;
    EXPECT_EQ(rig.status, DeviceStatus::Ok);
  }
}

TEST(ArmDevice, IsLostByOneAnswerThatIsLaterThanASilenceMayBe)
{
  ScriptedRig rig;
  ASSERT_EQ(rig.device.open(), "");
  ask(rig, { 0.5, 0.0, 0.0 });
  rig.script->takes_ns = ArmLink::silence_ns + perMs_ns;
  rig.run(1);
  rig.script->takes_ns = perMs_ns / 4;
  rig.run(50);
  EXPECT_EQ(rig.script->last.wrench_D.force.norm(), 0.0) << "until the servo has asked for none";
  EXPECT_EQ(rig.device.linkReport().losses, 1u);
}

TEST(ArmDevice, WhoseAnswersAllComeTooLateIsLostAndTheReasonIsSaid)
{
  ScriptedRig rig;
  ASSERT_EQ(rig.device.open(), "");
  ask(rig, { 0.5, 0.0, 0.0 });
  rig.script->takes_ns = ArmLink::answer_ms * perMs_ns + 1;
  for (const std::int64_t until_ns = rig.time.now_ns() + 20 * perMs_ns; rig.time.now_ns() < until_ns;)
  {
    rig.run(1);
  }
  EXPECT_GE(rig.lostTicks, 1);
  EXPECT_EQ(rig.script->last.wrench_D.force.norm(), 0.0);
  EXPECT_EQ(rig.device.linkReport().lostFor, "the device answers too late");
}

/// Answers of a whole period each, until the rate is counted anew; the answer that ends a second is its last.
double rateAfter(ScriptedRig& rig, std::int64_t period_ns)
{
  rig.script->takes_ns = period_ns;
  const std::int64_t from_ns = rig.time.now_ns();
  while (rig.time.now_ns() - from_ns < 2100 * perMs_ns) // more than a second after the second before
  {
    rig.run(1);
  }
  return rig.device.linkReport().inputRate_Hz;
}

// The counter spans whole answers: N of them, over the time from the answer before them to the last, a second or more.
TEST(ArmDevice, ReportsHowManyAnswersASecondItGets)
{
  ScriptedRig rig;
  ASSERT_EQ(rig.device.open(), "");
  rig.run(1000);
  EXPECT_EQ(rig.device.linkReport().inputRate_Hz, 0.0) << "no second is over";
  rig.run(2);
  EXPECT_DOUBLE_EQ(rig.device.linkReport().inputRate_Hz, 1000.0);
  for (const std::int64_t period_ns : { perMs_ns, 2 * perMs_ns, 3 * perMs_ns, std::int64_t{ 1234567 } })
  {
    EXPECT_NEAR(rateAfter(rig, period_ns), 1e9 / static_cast<double>(period_ns), 1e-9) << period_ns;
  }
  const LinkReport report = rig.device.linkReport();
  EXPECT_EQ(describeLink(report).find(std::to_string(std::lround(1e9 / 1234567.0)) + " reports per second"), 0U);
}

TEST(ArmDevice, CountsInItsRateNoAnswerThatDoesNotCome)
{
  ScriptedRig rig;
  ASSERT_EQ(rig.device.open(), "");
  rig.script->missing = 10;
  // An exchange with an answer is followed by another one 1000 exchanges later: 900 answers in that second.
  EXPECT_DOUBLE_EQ(rateAfter(rig, perMs_ns), 900.0);
}

TEST(ArmDevice, HasNoRateOnceItIsLost)
{
  ScriptedRig rig;
  ASSERT_EQ(rig.device.open(), "");
  ASSERT_NEAR(rateAfter(rig, perMs_ns), 1000.0, 1e-9);
  rig.script->takes_ns = ArmLink::silence_ns + perMs_ns;
  rig.run(1);
  EXPECT_EQ(rig.device.linkReport().losses, 1U);
  EXPECT_EQ(rig.device.linkReport().inputRate_Hz, 0.0);
  rig.script->takes_ns = perMs_ns / 4;
  rig.run(3000);
  EXPECT_DOUBLE_EQ(rig.device.linkReport().inputRate_Hz, 1000.0) << "the pause without it is no part of a second";
}

TEST(ArmDevice, SendsNoTorqueForItRendersNone)
{
  ScriptedRig rig;
  ASSERT_EQ(rig.device.open(), "");
  ASSERT_FALSE(rig.device.info().rendersTorque);
  for (const Vec3& force_N : { Vec3(0.5, 0.0, 0.0), Vec3(0.0, 0.0, 0.0) })
  {
    ask(rig, force_N, 1);
    rig.command.wrench_D.torque = { 0.0, 2.0, 0.0 };
    rig.run(5);
    EXPECT_EQ(rig.script->last.wrench_D.force, force_N);
    EXPECT_EQ(rig.script->last.wrench_D.torque, Vec3(Vec3::Zero()));
  }
}

/// An encoder that no longer counts looks like a hand that holds still.
TEST(ArmDevice, LosesItsForceWithinASecondAndAHalfWhileItsReadingsStayTheSameUnderForceAndSaysSo)
{
  ScriptedRig rig;
  ASSERT_EQ(rig.device.open(), "");
  ask(rig, { 0.5, 0.0, 0.0 }, 500);
  EXPECT_EQ(rig.script->last.wrench_D.force.x(), 0.5);
  rig.run(500);
  const double tick = 1e-3 / StillReading::falls_s;
  EXPECT_NEAR(rig.script->last.wrench_D.force.x(), 0.5 * 0.5, 0.5 * 3.0 * tick) << "half a second of the fall";
  EXPECT_EQ(rig.device.linkReport().message, "");
  rig.run(510);
  EXPECT_EQ(rig.script->last.wrench_D.force.norm(), 0.0);
  EXPECT_THAT(rig.device.linkReport().message, testing::HasSubstr("the readings have not changed for 1.5 s"));
  EXPECT_EQ(rig.status, DeviceStatus::Ok) << "it is not lost: it may be a hand";
  double x_m = 0.0;
  rig.script->hand = [&x_m](const Vec3&) { return Vec3(x_m += 1e-6, 0.0, 0.0); };
  rig.run(250);
  EXPECT_NEAR(rig.script->last.wrench_D.force.x(), 0.5 * 0.5, 0.5 * 3.0 * 1e-3 / StillReading::rises_s);
  EXPECT_EQ(rig.device.linkReport().message, "");
  rig.run(260);
  EXPECT_EQ(rig.script->last.wrench_D.force.x(), 0.5);
}

TEST(ArmDevice, KeepsASmallForceHoweverLongItsReadingsStayTheSame)
{
  ScriptedRig rig;
  ASSERT_EQ(rig.device.open(), "");
  const double small_N = 0.99 * PositionWatch::counts * rig.device.info().maxForce_N.value;
  ask(rig, { small_N, 0.0, 0.0 }, 3000);
  EXPECT_EQ(rig.script->last.wrench_D.force.x(), small_N);
}

/// A handle on a wall, pressed by a weight, that friction holds and an encoder reads in steps: the force falls until
/// the handle slips, by no more than friction and a step of the wall.
TEST(ArmDevice, ThatRestsOnAWallKeepsItsForceToFrictionAndOneStepOfItsEncoder)
{
  ScriptedRig rig;
  rig.device.prove();
  ASSERT_EQ(rig.device.open(), "");
  constexpr double weight_N = 1.5, friction_N = 0.26, wall_N_per_m = 500.0, step_m = 5e-5, way_m = 1e-6;
  double depth_m = weight_N / wall_N_per_m;
  rig.script->hand = [&](const Vec3& force_N)
  {
    const double down_N = weight_N - force_N.x();
    depth_m += std::fabs(down_N) > friction_N ? std::copysign(way_m, down_N) : 0.0;
    return Vec3(-step_m * std::floor(depth_m / step_m), 0.0, 0.0);
  };
  rig.run(5);
  double least_N = weight_N, most_N = 0.0;
  for (int i = 0; i < 20000; ++i)
  {
    rig.command.wrench_D.force.x() = -wall_N_per_m * rig.sample.pose_D.p.x();
    rig.run(1);
    least_N = std::min(least_N, rig.script->last.wrench_D.force.x());
    most_N = std::max(most_N, rig.script->last.wrench_D.force.x());
  }
  // While the handle slips by a step the share falls on.
  const double falls_N = (step_m / way_m + 3.0) * 1e-3 / StillReading::falls_s * (weight_N + 2.0 * friction_N);
  EXPECT_GT(least_N, weight_N - friction_N - falls_N);
  EXPECT_LT(least_N, weight_N) << "the force has been tried";
  EXPECT_LT(most_N, weight_N + friction_N + 2.0 * wall_N_per_m * step_m);
}

TEST(ArmDevice, KeepsItsLimitBehindACalibrationThatNobodyHasFelt)
{
  const HidEntry entry{ "line", 1, 2, "7", "scripted" };
  const auto script = std::make_shared<Script>();
  auto arm = std::make_unique<ArmDevice>("arm", busOf(script, entry), entry, turningSetup());
  const Calibration unfelt = wheelCalibration(arm->info(), "2026-01-31");
  const CalibratedDevice device(std::move(arm), unfelt);
  EXPECT_EQ(device.info().maxForce_N.value, 1.0);
}

TEST(ArmDevice, ThatCannotBeUsedSaysWhyWhenItIsOpened)
{
  const HidEntry entry{ "line", 1, 2, "7", "scripted" };
  ArmSetup setup = turningSetup();
  setup.problem = "its file is missing";
  ArmDevice device("arm", busOf(std::make_shared<Script>(), entry), entry, setup);
  EXPECT_EQ(device.open(), "\"arm\": its file is missing");
}

} // namespace
} // namespace palpate
