// SPDX-License-Identifier: GPL-3.0-or-later
// Devices that begin each period themselves.
#include <atomic>
#include <memory>
#include <semaphore>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "devices/calibration/CalibratedDevice.h"
#include "haptics/session/DeviceTimer.h"
#include "haptics/session/HapticSession.h"
#include "haptics/session/ServoLoop.h"
#include "testing/support/BareDevice.h"

namespace palpate
{
namespace
{

constexpr std::int64_t period_ns = 1'000'000;

/// A time that a device moves on.
class MovedClock final : public Clock
{
public:
  std::int64_t time_ns = 0;
  [[nodiscard]] std::int64_t now_ns() const noexcept override { return this->time_ns; }
};

/// Its samples come after these times, then it has no more.
class UnevenDevice final : public test::BareDevice
{
public:
  UnevenDevice(MovedClock& clock, std::vector<std::int64_t> after_ns)
    : BareDevice("uneven", true), clock_(clock), after_ns_(std::move(after_ns))
  {
  }
  void await() noexcept override
  {
    if (this->next_ < this->after_ns_.size())
    {
      this->clock_.time_ns += this->after_ns_[this->next_];
    }
    ++this->next_;
  }
  [[nodiscard]] DeviceStatus read(double time_s, DeviceSample& sample) noexcept override
  {
    sample = DeviceSample{};
    sample.time_s = time_s;
    return this->next_ > this->after_ns_.size() ? DeviceStatus::Ended : DeviceStatus::Ok;
  }
  void write(const DeviceCommand& /*command*/) noexcept override {}

private:
  MovedClock& clock_;
  std::vector<std::int64_t> after_ns_;
  std::size_t next_ = 0;
};

TEST(DevicePacing, CountsWholePeriodsBetweenTwoSamplesToTheNearest)
{
  MovedClock clock;
  UnevenDevice device(clock, { 7'000'000, 1'000'000, 3'000'000, 900'000, 1'400'000, 25'000'000 });
  DeviceTimer timer(device, clock, period_ns);
  const std::uint64_t missed[] = { 0, 0, 2, 0, 0, 24 }; // nobody knows how long the first one took
  const std::int64_t lateness_ns[] = { 0, 0, 0, 0, 400'000, 0 };
  for (std::size_t i = 0; i < std::size(missed); ++i)
  {
    const Wakeup wakeup = timer.wait();
    EXPECT_EQ(wakeup.missed, missed[i]) << i;
    EXPECT_EQ(wakeup.lateness_ns, lateness_ns[i]) << i;
    EXPECT_EQ(wakeup.due_ns + wakeup.lateness_ns, clock.time_ns) << i;
  }
}

TEST(DevicePacing, ATickIsComputedForEachSampleOverTheTimeSinceTheOneBefore)
{
  MovedClock clock;
  UnevenDevice device(clock, { 1'000'000, 1'000'000, 3'000'000, 2'000'000 });
  DeviceTimer timer(device, clock, period_ns);
  ServoLinks links;
  links.parameters.write({ 1, {} });
  ServoLoop loop(device, timer, links, clock, 1e-9 * static_cast<double>(period_ns));
  std::vector<std::uint64_t> periods;
  while (loop.tick())
  {
    periods.push_back(links.state.read().tick);
  }
  EXPECT_EQ(periods, (std::vector<std::uint64_t>{ 1, 2, 5, 7 }));
}

/// A thread of the maker's calls it; its samples are counted, and so are those that nobody had waited for.
class CallingDevice final : public test::BareDevice
{
public:
  CallingDevice(Pacing pacing, std::atomic<int>& unawaited, std::atomic<int>& reads)
    : BareDevice("calling", true), unawaited_(unawaited), reads_(reads)
  {
    this->paced_ = BareDevice::info();
    this->paced_.pacing = pacing;
    this->maker_ = std::jthread(
      [this]
      {
        for (int i = 0; i < samples; ++i)
        {
          this->called_.release();
        }
      });
  }
  [[nodiscard]] const DeviceInfo& info() const noexcept override { return this->paced_; }
  void await() noexcept override
  {
    if (this->left_ > 0)
    {
      this->called_.acquire();
      --this->left_;
    }
    this->awaited_ = true;
  }
  [[nodiscard]] DeviceStatus read(double /*time_s*/, DeviceSample& sample) noexcept override
  {
    sample = DeviceSample{};
    this->unawaited_ += this->awaited_ ? 0 : 1;
    this->awaited_ = false;
    return ++this->reads_ > samples ? DeviceStatus::Ended : DeviceStatus::Ok;
  }
  void write(const DeviceCommand& /*command*/) noexcept override {}

  static constexpr int samples = 50;

private:
  std::atomic<int>& unawaited_;
  std::atomic<int>& reads_;
  DeviceInfo paced_;
  bool awaited_ = false;
  int left_ = samples;
  std::counting_semaphore<> called_{ 0 };
  std::jthread maker_;
};

/// The device as a person's calibration shows it.
std::unique_ptr<HapticDevice> calibrated(std::unique_ptr<HapticDevice> device)
{
  const Calibration calibration = wheelCalibration(device->info(), "2026-01-01");
  return std::make_unique<CalibratedDevice>(std::move(device), calibration);
}

/// Runs a session on a device of that pacing to its end; how many samples nobody had waited for.
int unawaitedSamples(Pacing pacing, bool isCalibrated = false)
{
  std::atomic<int> unawaited = 0, reads = 0;
  std::unique_ptr<HapticDevice> device = std::make_unique<CallingDevice>(pacing, unawaited, reads);
  device = isCalibrated ? calibrated(std::move(device)) : std::move(device);
  HapticSession session;
  EXPECT_EQ(session.start(std::move(device), {}), "");
  while (reads <= CallingDevice::samples)
  {
    std::this_thread::yield();
  }
  EXPECT_EQ(session.stop(), "");
  EXPECT_EQ(session.report().ticks, static_cast<std::uint64_t>(CallingDevice::samples));
  return unawaited;
}

TEST(DevicePacing, ASessionWaitsForEachSampleOfADeviceThatPacesItAndOfNoOther)
{
  EXPECT_EQ(unawaitedSamples(Pacing::Device), 0);
  EXPECT_EQ(unawaitedSamples(Pacing::Callback), 0);
  EXPECT_EQ(unawaitedSamples(Pacing::Device, true), 0) << "a calibration changes nothing of it";
  EXPECT_EQ(unawaitedSamples(Pacing::Timer), CallingDevice::samples + 1) << "and the read that tells the end";
}

} // namespace
} // namespace palpate
