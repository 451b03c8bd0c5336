// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/calibration/SelfTestRun.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "devices/io/LinkedDevice.h"
#include "devices/simulated/SimulatedDevice.h"
#include "haptics/realtime/PeriodicTimer.h"
#include "haptics/realtime/TripleBuffer.h"

namespace palpate
{
namespace
{

/// A simulated hand that goes where it is asked to, as fast as people do.
class ObligingHand
{
public:
  explicit ObligingHand(HapticDevice& device) : device_(dynamic_cast<SimulatedDevice*>(&device)) {}

  void follow(const Vec3& asked_D, double dt_s) noexcept
  {
    constexpr double pace_m_per_s = 0.1;
    if (this->device_ == nullptr)
    {
      return;
    }
    const Vec3 way_D = asked_D - this->at_D_;
    const double length_m = way_D.norm(), step_m = pace_m_per_s * dt_s;
    this->at_D_ = length_m > step_m ? Vec3(this->at_D_ + step_m / length_m * way_D) : asked_D;
    this->device_->lead(this->at_D_);
  }

private:
  SimulatedDevice* device_;
  Vec3 at_D_ = Vec3::Zero();
};

} // namespace

/// Everything that lives from start() to stop(). The loop belongs to one thread: its own, or in virtual time the
/// owner's.
struct SelfTestRun::Run
{
  Run(std::unique_ptr<HapticDevice> tested, const SelfTestPlan& plan_, const SelfTestOptions& options)
    : device(std::move(tested)), hand(*this->device), plan(plan_), period_s(options.period_s),
      virtualTime(options.virtualTime)
  {
    const auto period_ns = static_cast<std::int64_t>(options.period_s * 1e9 + 0.5);
    if (options.virtualTime)
    {
      this->timer = std::make_unique<VirtualTimer>(period_ns);
    }
    else
    {
      this->timer = std::make_unique<PeriodicTimer>(period_ns);
    }
  }

  /// One period. False once there is a verdict.
  bool tick() noexcept
  {
    const Wakeup wakeup = this->timer->wait();
    this->period += 1 + wakeup.missed;
    const double dt_s = static_cast<double>(1 + wakeup.missed) * this->period_s;
    this->hand.follow(askedPlace_D(this->plan, this->current), dt_s);
    DeviceSample sample;
    const DeviceStatus status = this->device->read(static_cast<double>(this->period) * this->period_s, sample);
    this->device->write(stepSelfTest(this->plan, sample, status, dt_s, this->current));
    this->shown.write(this->current);
    return this->current.verdict == SelfTestVerdict::None;
  }

  void finish() noexcept
  {
    stopSelfTest(this->current);
    this->device->write(DeviceCommand{});
    this->shown.write(this->current);
  }

  std::unique_ptr<HapticDevice> device;
  ObligingHand hand;
  SelfTestPlan plan;
  double period_s;
  bool virtualTime;
  std::unique_ptr<TickTimer> timer;
  std::uint64_t period = 0;
  SelfTestState current;
  TripleBuffer<SelfTestState> shown; ///< loop -> owner
  RealtimeThread thread;
};

SelfTestRun::SelfTestRun() = default;

SelfTestRun::~SelfTestRun()
{
  this->stop();
}

std::string SelfTestRun::start(std::unique_ptr<HapticDevice> device, const SelfTestOptions& options)
{
  this->stop();
  std::string problem = SelfTestPlan::forDevice(device->info()).refusal();
  if (problem.empty())
  {
    problem = device->open();
  }
  if (!problem.empty())
  {
    return problem;
  }
  // Some devices know what they can do only once they are open.
  this->device_ = device->info();
  if (const auto* linked = dynamic_cast<const LinkedDevice*>(device.get()))
  {
    this->device_.abilities = linked->abilitiesNow();
  }
  this->plan_ = SelfTestPlan::forDevice(this->device_, options.deadMan);
  this->lastState_ = SelfTestState{};
  this->run_ = std::make_unique<Run>(std::move(device), this->plan_, options);
  if (!options.virtualTime)
  {
    Run& r = *this->run_;
    r.thread = RealtimeThread([](const SchedulingReport&) {},
      [&r](const std::stop_token& stop)
      {
        while (!stop.stop_requested() && r.tick())
        {
        }
        r.finish();
      },
      options.brokers);
  }
  return {};
}

void SelfTestRun::stop()
{
  if (!this->run_)
  {
    return;
  }
  if (this->run_->virtualTime)
  {
    this->run_->finish();
  }
  else
  {
    this->run_->thread.join();
  }
  this->lastState_ = this->run_->shown.read();
  this->run_->device->close();
  this->run_.reset();
}

void SelfTestRun::step(int ticks)
{
  for (int i = 0; i < ticks && this->run_ && this->run_->virtualTime && this->run_->tick(); ++i)
  {
  }
}

const SelfTestState& SelfTestRun::state()
{
  if (this->run_)
  {
    this->lastState_ = this->run_->shown.read();
  }
  return this->lastState_;
}

} // namespace palpate
