// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <utility>

#include "haptics/core/HapticDevice.h"
#include "haptics/realtime/PeriodicTimer.h"
#include "haptics/realtime/RealtimeThread.h"
#include "haptics/realtime/TripleBuffer.h"

namespace palpate
{

/// How a device is paced.
struct DeviceLoopOptions
{
  double period_s = 1e-3;
  bool virtualTime = false; ///< nothing runs by itself: step() computes ticks in the caller's thread
  RealtimeBrokers brokers;  ///< who is asked for real-time priority where the user's limits do not allow it
};

/// An open device and a tick that is called once per period with the sample of the device, in a thread of its own or in
/// virtual time in the owner's. All methods are the owner's. `Tick` has, real-time safe and noexcept,
///
///     void before(double dt_s, const State& state)
///     DeviceCommand step(const DeviceSample& sample, DeviceStatus status, double dt_s, State& state)
///     bool goesOn(const State& state)
///     void end(State& state)
///
/// The destructor ends it with zero force and closes the device.
template<class State, class Tick>
class DeviceLoop
{
public:
  DeviceLoop(std::unique_ptr<HapticDevice> device, Tick tick, const DeviceLoopOptions& options)
    : device_(std::move(device)), tick_(std::move(tick)), period_s_(options.period_s)
  {
    const auto period_ns = static_cast<std::int64_t>(options.period_s * 1e9 + 0.5);
    if (options.virtualTime)
    {
      this->timer_ = std::make_unique<VirtualTimer>(period_ns);
      return;
    }
    this->timer_ = std::make_unique<PeriodicTimer>(period_ns);
    this->thread_ = RealtimeThread([](const SchedulingReport&) {},
      [this](const std::stop_token& stop)
      {
        while (!stop.stop_requested() && this->tick())
        {
        }
        this->finish();
      },
      options.brokers);
  }
  ~DeviceLoop()
  {
    this->stop();
    this->device_->close();
  }
  DeviceLoop(const DeviceLoop&) = delete;
  DeviceLoop& operator=(const DeviceLoop&) = delete;

  /// Zero force; the device stays open.
  void stop()
  {
    if (std::exchange(this->stopped_, true))
    {
      return;
    }
    this->thread_.joinable() ? this->thread_.join() : this->finish();
  }
  /// Virtual time: computes up to that many ticks now.
  void step(int ticks)
  {
    for (int i = 0; i < ticks && !this->stopped_ && !this->thread_.joinable() && this->tick(); ++i)
    {
    }
  }
  /// The newest.
  [[nodiscard]] const State& state() { return this->shown_.read(); }
  [[nodiscard]] const HapticDevice& device() const noexcept { return *this->device_; }

private:
  bool tick() noexcept
  {
    const Wakeup wakeup = this->timer_->wait();
    this->period_ += 1 + wakeup.missed;
    const double dt_s = static_cast<double>(1 + wakeup.missed) * this->period_s_;
    this->tick_.before(dt_s, this->current_);
    DeviceSample sample;
    const DeviceStatus status = this->device_->read(static_cast<double>(this->period_) * this->period_s_, sample);
    this->device_->write(this->tick_.step(sample, status, dt_s, this->current_));
    this->shown_.write(this->current_);
    return this->tick_.goesOn(this->current_);
  }

  void finish() noexcept
  {
    this->tick_.end(this->current_);
    this->device_->write(DeviceCommand{});
    this->shown_.write(this->current_);
  }

  std::unique_ptr<HapticDevice> device_;
  Tick tick_;
  double period_s_;
  std::unique_ptr<TickTimer> timer_;
  std::uint64_t period_ = 0;
  State current_;
  TripleBuffer<State> shown_; ///< loop -> owner
  bool stopped_ = false;
  RealtimeThread thread_; ///< last: it uses all of the above
};

} // namespace palpate
