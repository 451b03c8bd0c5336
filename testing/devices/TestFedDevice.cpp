// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "devices/DeviceFactory.h"
#include "devices/FedDevice.h"
#include "testing/support/AllocationGuard.h"

namespace palpate
{
namespace
{

constexpr double tick_s = 1e-3;
constexpr double fastest_m_per_s = 0.5; // of the mouse's hand
constexpr double longestGlide_s = 0.05;

DeviceSample at(double x_m)
{
  DeviceSample sample;
  sample.pose_D.p = Vec3(x_m, 0, 0);
  return sample;
}

/// The mouse's hand, tick by tick.
class MouseHand : public ::testing::Test
{
protected:
  double tick()
  {
    DeviceSample sample;
    EXPECT_EQ(this->mouse_->read(tick_s * static_cast<double>(this->ticks_++), sample), DeviceStatus::Ok);
    return sample.pose_D.p.x();
  }
  /// The x of so many ticks after a new pose.
  std::vector<double> glide(double to_m, int ticks)
  {
    this->mouse_->feed(at(to_m));
    std::vector<double> x_m(static_cast<std::size_t>(ticks));
    std::generate(x_m.begin(), x_m.end(), [this] { return this->tick(); });
    return x_m;
  }

  std::unique_ptr<FedDevice> mouse_ = FedDevice::mouse();
  long ticks_ = 0;
};

TEST(FedDevice, GivesTheLatestPoseWithTheTicksTime)
{
  FedDevice device;
  DeviceSample fed, read;
  fed.pose_D.p = { 1, 2, 3 };
  fed.time_s = 99.0;
  device.feed(fed);
  EXPECT_EQ(device.read(0.5, read), DeviceStatus::Ok);
  EXPECT_EQ(read.pose_D.p, Vec3(1, 2, 3));
  EXPECT_EQ(read.time_s, 0.5);
}

TEST(FedDevice, WaitsUntilItIsFed)
{
  FedDevice device;
  DeviceSample read;
  EXPECT_EQ(device.read(0.5, read), DeviceStatus::Waiting);
  device.feed(at(0.0));
  EXPECT_EQ(device.read(0.6, read), DeviceStatus::Ok);
}

TEST(FedDevice, IsNowhereWhileItIsWithdrawnAndThenThereAtOnce)
{
  const std::unique_ptr<FedDevice> mouse = FedDevice::mouse();
  DeviceSample read;
  mouse->feed(at(0.0));
  EXPECT_EQ(mouse->read(0.001, read), DeviceStatus::Ok);
  mouse->withdraw();
  EXPECT_EQ(mouse->read(0.002, read), DeviceStatus::Waiting);
  mouse->feed(at(5.0));
  EXPECT_EQ(mouse->read(0.003, read), DeviceStatus::Ok);
  EXPECT_EQ(read.pose_D.p.x(), 5.0);
}

TEST_F(MouseHand, IsAtItsFirstPoseAtOnce)
{
  EXPECT_EQ(this->glide(7.0, 1).back(), 7.0);
}

// Poses each n ticks, h apart: after the second the hand goes h / n a tick and arrives when the next one is due.
TEST_F(MouseHand, GlidesEvenlyBetweenThePosesOfAScreen)
{
  constexpr int n = 16;
  constexpr double h = 0.002;
  this->glide(0.0, n);
  for (int pose = 1; pose <= 5; ++pose)
  {
    const std::vector<double> x_m = this->glide(h * pose, n);
    for (int i = 0; i < n; ++i)
    {
      ASSERT_NEAR(x_m[i], h * (pose - 1) + h * (i + 1) / n, 1e-15);
    }
  }
}

TEST_F(MouseHand, IsNoFasterThanAHandAndArrives)
{
  this->glide(0.0, 1000);
  constexpr double far_m = 0.1;
  const int ticks = static_cast<int>(std::lround(far_m / (fastest_m_per_s * tick_s)));
  double before_m = 0.0;
  for (const double x_m : this->glide(far_m, ticks + 2))
  {
    ASSERT_LE(x_m - before_m, fastest_m_per_s * tick_s * (1 + 1e-12));
    before_m = x_m;
  }
  EXPECT_EQ(before_m, far_m);
}

TEST_F(MouseHand, AfterARestItTakesNoLongerThanThreeFrames)
{
  this->glide(0.0, 1000);
  constexpr double h = 0.005;
  const int ticks = static_cast<int>(std::lround(longestGlide_s / tick_s));
  const std::vector<double> x_m = this->glide(h, ticks + 1);
  EXPECT_NEAR(x_m[ticks / 2 - 1], 0.5 * h, 1e-12);
  EXPECT_EQ(x_m.back(), h);
}

// A pose that is fed after it, before any tick, must not make a motion of it again.
TEST_F(MouseHand, IsAtOnceWhereItIsPut)
{
  this->glide(0.0, 100);
  this->mouse_->place(at(5.0));
  this->mouse_->feed(at(5.0));
  EXPECT_EQ(this->tick(), 5.0);
  EXPECT_LT(this->glide(6.0, 1).back(), 5.001);
}

TEST_F(MouseHand, IsBackAfterAPoseThatWasNotFinite)
{
  this->glide(0.0, 10);
  EXPECT_FALSE(std::isfinite(this->glide(std::numeric_limits<double>::quiet_NaN(), 3).back()));
  EXPECT_EQ(this->glide(0.01, 60).back(), 0.01);
}

TEST_F(MouseHand, CostsTheServoNoAllocation)
{
  this->mouse_->feed(at(0.0));
  const test::AllocationGuard guard;
  this->mouse_->feed(at(0.01));
  for (int i = 0; i < 100; ++i)
  {
    this->tick();
  }
  EXPECT_EQ(guard.allocations() + guard.frees() + guard.locks(), 0U);
}

TEST(FedDevice, IsThereAtTheNextTickHoweverFar)
{
  FedDevice script;
  DeviceSample sample;
  for (const double x_m : { 0.0, 5.0 })
  {
    script.feed(at(x_m));
    EXPECT_EQ(script.read(0.0, sample), DeviceStatus::Ok);
    EXPECT_EQ(sample.pose_D.p.x(), x_m);
  }
}

TEST(FedDevice, BothAreKnownByNameAndPushNobody)
{
  for (const char* const name : { "fed", "mouse" })
  {
    const MadeDevice made = makeDevice(name, {});
    ASSERT_NE(made.device, nullptr) << made.problem;
    EXPECT_EQ(made.device->info().name, name);
    EXPECT_FALSE(made.device->info().rendersForce);
  }
}

} // namespace
} // namespace palpate
