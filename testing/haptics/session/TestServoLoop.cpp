// SPDX-License-Identifier: GPL-3.0-or-later
// The servo loop in virtual time: lateness, faults, and forbidden actions.
#include <algorithm>
#include <functional>
#include <optional>

#include <gtest/gtest.h>

#include "haptics/recording/Recording.h"
#include "haptics/session/ServoLoop.h"
#include "haptics/session/Warning.h"
#include "testing/haptics/session/HoldingTick.h"
#include "testing/support/AllocationGuard.h"
#include "testing/support/BareDevice.h"
#include "testing/support/Meshes.h"
#include "testing/support/TemporaryFolder.h"

namespace palpate
{
namespace
{

constexpr std::int64_t servoPeriod_ns = 1'000'000;
constexpr double period_s = 1e-3;

/// A hand that the test moves.
class MovedDevice final : public test::BareDevice
{
public:
  explicit MovedDevice(bool simulated) : BareDevice("moved", simulated) {}
  [[nodiscard]] DeviceStatus read(double time_s, DeviceSample& sample) noexcept override
  {
    sample = DeviceSample{};
    sample.time_s = time_s;
    sample.pose_D.p = this->p_D;
    if (this->whileAsked)
    {
      this->whileAsked();
    }
    return this->status;
  }
  void write(const DeviceCommand& command) noexcept override
  {
    const Vec3 force_D = command.wrench_D.force + forceOfWalls(command, this->p_D);
    this->fall_N = std::max(this->fall_N, this->force_D.norm() - force_D.norm());
    this->force_D = force_D;
    this->wallCount = command.wallCount;
  }

  Vec3 p_D = { 0, 0, 0.06 };
  Vec3 force_D = Vec3::Zero(); ///< of the command and of the walls it holds
  double fall_N = 0.0;         ///< most from one tick to the next
  int wallCount = 0;
  DeviceStatus status = DeviceStatus::Ok;
  std::function<void()> whileAsked; ///< done by another thread, as it were
};

/// A sphere of radius 50 mm, a device, and the loop between them.
struct Rig
{
  explicit Rig(bool simulated) : device(simulated)
  {
    HapticParameters parameters;
    parameters.safety.engageRamp_s = 0.01;
    this->links.parameters.write({ 1, parameters });
    this->links.scenes.publish(this->scene);
    this->links.events.tryPush({ 0, EventKind::Engage, 0 });
    this->loop.emplace(this->device, this->timer, this->links, this->clock, period_s);
  }

  void run(int ticks, std::int64_t lateness_ns = 0)
  {
    for (int i = 0; i < ticks; ++i)
    {
      this->timer.delayNext(lateness_ns);
      static_cast<void>(this->loop->tick());
    }
  }
  /// Touches from outside and presses until the force is settled.
  void press()
  {
    this->run(1);
    this->device.p_D = this->pressed_D;
    this->run(200);
  }

  /// The device holds the wall y = 0.05 of a plane world instead, free where y is larger.
  void hold()
  {
    HapticParameters parameters = test::holding();
    parameters.safety = SafetyLimits{};
    parameters.safety.engageRamp_s = 0.01;
    this->links.parameters.write({ 2, parameters });
    this->scene = test::sceneOf(CurveSet{ { { -0.04, 0.05 }, { 0.04, 0.05 } }, { { 0, 1 } } });
    this->links.scenes.publish(this->scene);
    this->device.p_D = { 0, 0.06, 0 };
    this->pressed_D = { 0, 0.045, 0 };
  }
  /// Asked to stop, after a release, as a session does it. Returns the ticks until it had ended.
  std::uint64_t stop()
  {
    const std::uint64_t before = this->links.state.read().tick;
    std::stop_source source;
    source.request_stop();
    this->links.events.tryPush({ 0, EventKind::Release, 0 });
    this->device.fall_N = 0.0;
    this->loop->run(source.get_token());
    return this->links.state.read().tick - before;
  }

  std::shared_ptr<const Scene> scene = test::sceneOf(test::makeIcosphere(4, 0.05));
  MovedDevice device;
  Vec3 pressed_D = { 0, 0, 0.0485 };
  VirtualTimer timer{ servoPeriod_ns };
  MonotonicClock clock;
  ServoLinks links;
  std::optional<ServoLoop> loop;
};

TEST(ServoLoop, AGapAboveTwentyMillisecondsDropsARealDevicesForceWithinTen)
{
  Rig rig(false);
  rig.press();
  const double full = rig.device.force_D.norm();
  ASSERT_GT(full, 1.0);
  rig.run(1, 21 * servoPeriod_ns);
  EXPECT_EQ(rig.links.state.read().fault, Fault::LateServo);
  rig.run(10);
  EXPECT_EQ(rig.device.force_D.norm(), 0.0);
  rig.run(1000);
  EXPECT_EQ(rig.device.force_D.norm(), 0.0) << "only the person engages again";
  rig.device.p_D.z() = 0.06;
  rig.links.events.tryPush({ 0, EventKind::Engage, 0 });
  rig.press();
  EXPECT_NEAR(rig.device.force_D.norm(), full, 1e-11);
}

TEST(ServoLoop, AGapBelowTwentyMillisecondsIsCountedOnly)
{
  Rig rig(false);
  rig.press();
  rig.run(1, 15 * servoPeriod_ns);
  EXPECT_EQ(rig.links.state.read().fault, Fault::None);
  EXPECT_GT(rig.device.force_D.norm(), 1.0);
  rig.loop->publishReport();
  const LoopReport& report = rig.links.report.read();
  EXPECT_EQ(report.missed, 15U);
  EXPECT_EQ(report.ticks + report.missed, report.periods);
}

TEST(ServoLoop, ASimulatedDeviceOnlyCountsItsLateness)
{
  Rig rig(true);
  rig.press();
  rig.run(1, 500 * servoPeriod_ns);
  EXPECT_EQ(rig.links.state.read().fault, Fault::None);
  EXPECT_GT(rig.device.force_D.norm(), 1.0);
}

TEST(ServoLoop, SteadyLatenessOfTwoMillisecondsLeavesTheStiffnessThatRateCanHold)
{
  Rig rig(false);
  rig.press();
  const double full = rig.device.force_D.norm();
  rig.run(3000, 2 * servoPeriod_ns);
  EXPECT_EQ(rig.links.state.read().fault, Fault::None);
  // K ~ 1 / (T / 2 + lateness): 0.5 ms of 0.5 ms + 2 ms.
  EXPECT_NEAR(rig.device.force_D.norm(), 0.5 / 2.5 * full, 1e-11);
  EXPECT_EQ(warning(rig.links.state.read(), rig.links.report.read()),
    "the servo is late by 2.0 ms (99th percentile): stiffness limited to 20 %; close other programs or grant real-time "
    "priority");
}

TEST(ServoLoop, LatenessThatCostsNoStiffnessIsNoWarning)
{
  Rig rig(false);
  rig.press();
  rig.run(3000, servoPeriod_ns / 2);
  EXPECT_EQ(rig.links.state.read().stiffnessFactor, 1.0);
  EXPECT_EQ(warning(rig.links.state.read(), rig.links.report.read()), "");
}

TEST(ServoLoop, SteadyLatenessAboveFiveMillisecondsDropsTheForce)
{
  Rig rig(false);
  rig.press();
  rig.run(1000, 6 * servoPeriod_ns);
  EXPECT_EQ(rig.links.state.read().fault, Fault::LateServo);
  EXPECT_EQ(rig.device.force_D.norm(), 0.0);
}

TEST(ServoLoop, APoseIsNeverPutThroughAMapThatIsNewerThanThePose)
{
  Rig rig(true);
  rig.run(1);
  HapticParameters moved;
  moved.map.offset_W = Vec3(1, 0, 0);
  rig.device.whileAsked = [&] { rig.links.parameters.write({ 2, moved }); };
  rig.run(1);
  EXPECT_EQ(rig.links.state.read().device_W.p, rig.device.p_D);
  rig.device.whileAsked = {};
  rig.run(1);
  EXPECT_EQ(rig.links.state.read().device_W.p, rig.device.p_D + Vec3(1, 0, 0));
}

TEST(ServoLoop, ALostDeviceGetsNoForceInTheVeryTickAndTheFaultIsShown)
{
  Rig rig(false);
  rig.press();
  rig.device.status = DeviceStatus::Lost;
  rig.run(1);
  EXPECT_EQ(rig.device.force_D.norm(), 0.0);
  EXPECT_EQ(rig.links.state.read().fault, Fault::DeviceLost);
}

TEST(ServoLoop, TheEndLeavesTheDeviceWithoutForce)
{
  Rig rig(true);
  rig.press();
  ASSERT_GT(rig.device.force_D.norm(), 1.0);
  rig.device.status = DeviceStatus::Ended;
  EXPECT_FALSE(rig.loop->tick());
  rig.loop->finish();
  EXPECT_EQ(rig.device.force_D.norm(), 0.0);
  EXPECT_TRUE(rig.links.report.read().ended);
}

// The gain falls by dt / 50 ms a tick, and smoothstep is nowhere steeper than 3/2.
TEST(ServoLoop, WhoIsPushedWhenItIsToStopIsLetGoAsSlowlyAsByARelease)
{
  Rig rig(false);
  rig.press();
  const double full_N = rig.device.force_D.norm();
  ASSERT_GT(full_N, 0.7);
  EXPECT_NEAR(static_cast<double>(rig.stop()), 50.0, 2.0);
  EXPECT_LE(rig.device.fall_N, 1.5 * full_N / 50 + 1e-12);
  EXPECT_EQ(rig.device.force_D.norm(), 0.0);
}

TEST(ServoLoop, WallsThatADeviceHoldsAreTakenFromTheHandAsSlowlyWhenItIsToStop)
{
  Rig rig(false);
  rig.hold();
  rig.press();
  ASSERT_EQ(rig.device.wallCount, 1);
  const double full_N = rig.device.force_D.norm();
  ASSERT_GT(full_N, 0.7);
  EXPECT_NEAR(static_cast<double>(rig.stop()), 50.0, 2.0);
  EXPECT_LE(rig.device.fall_N, 1.5 * full_N / 50 + 1e-12);
  EXPECT_EQ(rig.device.wallCount, 0);
}

TEST(ServoLoop, WallsThatADeviceHoldsStayWhenARecordingBegins)
{
  const test::TemporaryFolder folder;
  Recorder recorder;
  ASSERT_EQ(recorder.open(folder.file("walls"), "moved", false), "");
  Rig rig(false);
  rig.hold();
  rig.press();
  ASSERT_EQ(rig.device.wallCount, 1);
  rig.device.fall_N = 0.0;
  recorder.store<input::Scenes>(rig.scene);
  rig.links.recorder = &recorder;
  rig.run(50);
  EXPECT_LT(rig.device.fall_N, 1e-12);
  ASSERT_EQ(recorder.close(), "");
  const auto read = readRecording(folder.file("walls"));
  ASSERT_TRUE(std::holds_alternative<Recording>(read)) << std::get<std::string>(read);
  const ReplayResult result = replay(std::get<Recording>(read));
  EXPECT_EQ(result.problem + result.difference, "");
  EXPECT_EQ(result.ticks, 50U);
}

TEST(ServoLoop, WhoIsNotPushedWhenItIsToStopIsNotWaitedFor)
{
  Rig rig(false);
  rig.run(200);
  EXPECT_EQ(rig.stop(), 0U);
}

TEST(ServoLoop, AForceThatDoesNotGoEndsTheLoopAllTheSame)
{
  Rig rig(false);
  HapticParameters parameters;
  parameters.safety.needsEngage = false;
  rig.links.parameters.write({ 2, parameters });
  rig.press();
  ASSERT_GT(rig.device.force_D.norm(), 0.7);
  EXPECT_LE(rig.stop(), 60U);
  EXPECT_EQ(rig.device.force_D.norm(), 0.0);
}

TEST(ServoLoop, AScenePublishedTwiceAndAFaultAreInTheRecordingAndItReplays)
{
  const test::TemporaryFolder folder;
  const std::string path = folder.file("loop");
  Recorder recorder;
  ASSERT_EQ(recorder.open(path, "moved", false), "");
  {
    Rig rig(false);
    rig.links.recorder = &recorder;
    recorder.store<input::Scenes>(rig.scene);
    rig.press();
    rig.links.scenes.publish(rig.scene);
    rig.run(50);
    rig.run(1, 30 * servoPeriod_ns);
    rig.run(50);
  }
  ASSERT_EQ(recorder.close(), "");
  const auto read = readRecording(path);
  ASSERT_TRUE(std::holds_alternative<Recording>(read));
  const Recording& recording = std::get<Recording>(read);
  int scenes = 0;
  std::vector<HapticEvent> faults;
  for (const RecordedEntry& entry : recording.entries)
  {
    if (const auto* change = std::get_if<RecordedChange>(&entry))
    {
      scenes += change->event.kind == EventKind::Scene;
      if (change->event.kind == EventKind::Fault)
      {
        faults.push_back(change->event);
      }
    }
  }
  EXPECT_EQ(scenes, 2);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].value, static_cast<std::uint64_t>(Fault::LateServo));
  EXPECT_EQ(faults[0].tick, 201U + 50U + 31U); // the tick after 30 missed periods
  const ReplayResult result = replay(recording);
  EXPECT_EQ(result.problem + result.difference, "");
  EXPECT_EQ(result.ticks, 302U);
}

TEST(ServoLoop, NeitherAllocatesNorFreesNorLocksWhileScenesParametersAndEventsArrive)
{
  Rig rig(true);
  const auto other = std::make_shared<const Scene>(9, test::sceneOf(test::makeIcosphere(3, 0.05))->surfaces());
  rig.press();
  std::uint64_t allocations = 0, frees = 0, locks = 0;
  for (int i = 0; i < 3000; ++i)
  {
    if (i % 50 == 0)
    {
      rig.links.scenes.publish(i % 100 == 0 ? other : rig.scene);
      HapticParameters parameters;
      parameters.stiffness_N_per_m = 500.0 + i;
      rig.links.parameters.write({ static_cast<std::uint64_t>(2 + i), parameters });
      rig.links.events.tryPush({ 0, EventKind::Mark, 0 });
    }
    const test::AllocationGuard guard;
    static_cast<void>(rig.loop->tick());
    allocations += guard.allocations();
    frees += guard.frees();
    locks += guard.locks();
  }
  EXPECT_EQ(allocations, 0U);
  EXPECT_EQ(frees, 0U);
  EXPECT_EQ(locks, 0U);
}

} // namespace
} // namespace palpate
