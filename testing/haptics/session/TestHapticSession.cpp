// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "devices/FedDevice.h"
#include "devices/simulated/SimulatedDevice.h"
#include "haptics/session/HapticSession.h"
#include "haptics/session/LoopReport.h"
#include "testing/support/BareDevice.h"
#include "testing/support/Eventually.h"
#include "testing/support/Meshes.h"

namespace palpate
{
namespace
{

/// Keeps the last command it got where the test can see it after the session has gone.
class WatchedDevice : public test::BareDevice
{
public:
  explicit WatchedDevice(DeviceCommand& last) : BareDevice("watched", true), last_(last) {}
  [[nodiscard]] DeviceStatus read(double time_s, DeviceSample& sample) noexcept override
  {
    sample = DeviceSample{};
    sample.time_s = time_s;
    sample.pose_D.p = { 0, 0, time_s < 0.01 ? 0.06 : 0.049 };
    return DeviceStatus::Ok;
  }
  void write(const DeviceCommand& command) noexcept override { this->last_ = command; }

private:
  DeviceCommand& last_;
};

/// How a force went.
struct Course
{
  double peak_N = 0.0;
  double steepestFall_N_per_s = 0.0;
};

/// A force that is still there at the end, in no tick, falls at once.
class FallingDevice final : public WatchedDevice
{
public:
  FallingDevice(DeviceCommand& last, Course& course) : WatchedDevice(last), course_(course) {}
  [[nodiscard]] DeviceStatus read(double time_s, DeviceSample& sample) noexcept override
  {
    this->now_s_ = time_s;
    return WatchedDevice::read(time_s, sample);
  }
  void write(const DeviceCommand& command) noexcept override
  {
    const double force_N = command.wrench_D.force.norm();
    this->course_.peak_N = std::max(this->course_.peak_N, force_N);
    if (force_N < this->force_N_)
    {
      this->course_.steepestFall_N_per_s =
        std::max(this->course_.steepestFall_N_per_s, (this->force_N_ - force_N) / (this->now_s_ - this->then_s_));
    }
    this->force_N_ = force_N;
    this->then_s_ = this->now_s_;
    WatchedDevice::write(command);
  }

private:
  Course& course_;
  double force_N_ = 0.0;
  double now_s_ = 0.0, then_s_ = 0.0;
};

HapticParameters quickRamp()
{
  HapticParameters parameters;
  parameters.safety.engageRamp_s = 0.01;
  parameters.safety.engageBelow_N = 10.0;
  return parameters;
}

TEST(HapticSession, InVirtualTimeEveryPeriodIsATick)
{
  HapticSession session;
  session.setScene(test::sceneOf(test::makeIcosphere(3, 0.05)));
  DeviceCommand last;
  SessionOptions options;
  options.virtualTime = true;
  ASSERT_EQ(session.setParameters(quickRamp()), "");
  ASSERT_EQ(session.start(std::make_unique<WatchedDevice>(last), options), "");
  EXPECT_EQ(session.step(500), 500);
  EXPECT_EQ(session.report().ticks, 500U);
  EXPECT_EQ(session.report().periods, 500U);
  EXPECT_EQ(session.report().missed, 0U);
  EXPECT_LE(session.report().forceResidual_N, 1e-11);
  EXPECT_GT(last.wrench_D.force.norm(), 0.5);
  EXPECT_EQ(session.stop(), "");
  EXPECT_EQ(last.wrench_D.force.norm(), 0.0) << "the last command must be zero";
}

TEST(HapticSession, OnTheWallClockTicksPlusMissedPeriodsAreThePeriodsElapsed)
{
  HapticSession session;
  session.setScene(test::sceneOf(test::makeIcosphere(3, 0.05)));
  DeviceCommand last;
  ASSERT_EQ(session.setParameters(quickRamp()), "");
  ASSERT_EQ(session.start(std::make_unique<WatchedDevice>(last)), "");
  std::this_thread::sleep_for(std::chrono::milliseconds(400));
  EXPECT_EQ(session.stop(), "");
  const LoopReport& report = session.report();
  EXPECT_GT(report.ticks, 0U);
  EXPECT_EQ(report.ticks + report.missed, report.periods);
  EXPECT_EQ(last.wrench_D.force.norm(), 0.0);
}

// smoothstep over 50 ms is nowhere steeper than 3/2 of the whole in 50 ms; periods that are missed count as time.
TEST(HapticSession, OnTheWallClockStoppingLetsGoOfAPressedHandInARampToo)
{
  HapticSession session;
  session.setScene(test::sceneOf(test::makeIcosphere(3, 0.05)));
  DeviceCommand last;
  Course course;
  ASSERT_EQ(session.setParameters(quickRamp()), "");
  ASSERT_EQ(session.start(std::make_unique<FallingDevice>(last, course)), "");
  const auto settled = [&]
  {
    const HapticState& state = session.state();
    return state.gain == 1.0 && state.contacts > 0 && state.force_D == state.rendered_D;
  };
  ASSERT_TRUE(test::eventually(settled));
  EXPECT_EQ(session.stop(), "");
  EXPECT_EQ(last.wrench_D.force.norm(), 0.0);
  EXPECT_GT(course.steepestFall_N_per_s, 0.0);
  EXPECT_LE(course.steepestFall_N_per_s, 1.5 * course.peak_N / 0.05 * (1 + 1e-9));
}

TEST(HapticSession, SurvivesScenesParametersAndEventsArrivingWhileItRuns)
{
  HapticSession session;
  const auto one = test::sceneOf(test::makeIcosphere(2, 0.05));
  const auto two = std::make_shared<const Scene>(5, test::sceneOf(test::makeIcosphere(3, 0.05))->surfaces());
  DeviceCommand last;
  ASSERT_EQ(session.start(std::make_unique<WatchedDevice>(last)), "");
  for (int i = 0; i < 200; ++i)
  {
    session.setScene(i % 3 == 0 ? nullptr : (i % 3 == 1 ? one : two));
    HapticParameters parameters = quickRamp();
    parameters.stiffness_N_per_m = 100.0 + i;
    ASSERT_EQ(session.setParameters(parameters), "");
    i % 2 == 0 ? session.engage() : session.release();
    EXPECT_TRUE(session.state().force_D.allFinite());
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

TEST(HapticSession, RefusesParametersThatCannotBeAndKeepsTheOldOnes)
{
  HapticSession session;
  HapticParameters bad;
  bad.stiffness_N_per_m = -1.0;
  EXPECT_NE(session.setParameters(bad).find("stiffness"), std::string::npos);
  bad = {};
  bad.contact.radius_u = std::nan("");
  EXPECT_NE(session.setParameters(bad).find("radius"), std::string::npos);
  EXPECT_EQ(session.parameters().stiffness_N_per_m, HapticParameters{}.stiffness_N_per_m);
}

TEST(HapticSession, ADeviceThatCannotOpenKeepsItFromStartingAndSaysWhy)
{
  HapticSession session;
  session.setScene(test::sceneOf(test::makeIcosphere(1, 0.05)));
  auto withoutStroke = std::make_unique<SimulatedDevice>(DeviceModel{}, HandModel{}, HandPath{});
  EXPECT_NE(session.start(std::move(withoutStroke)).find("stroke"), std::string::npos);
  EXPECT_FALSE(session.running());
}

} // namespace
} // namespace palpate
