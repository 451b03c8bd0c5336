// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/calibration/SelfTestRun.h"

#include <algorithm>
#include <utility>

#include "devices/calibration/CalibratedDevice.h"
#include "devices/common/DeviceLoop.h"
#include "devices/common/DeviceSteps.h"
#include "devices/common/HeldTrust.h"
#include "devices/simulated/SimulatedDevice.h"

namespace palpate
{

/// Everything that lives from start() to stop().
struct SelfTestRun::Run
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

  /// The tick of a self-test.
  struct Tick
  {
    ObligingHand hand;
    SelfTestPlan plan;

    void before(double dt_s, const SelfTestState& state) noexcept
    {
      this->hand.follow(askedPlace_D(this->plan, state), dt_s);
    }
    DeviceCommand step(
      const DeviceSample& sample, DeviceStatus status, double dt_s, SelfTestState& state) const noexcept
    {
      return stepSelfTest(this->plan, sample, status, dt_s, state);
    }
    static bool goesOn(const SelfTestState& state) noexcept { return state.verdict == SelfTestVerdict::None; }
    static void end(SelfTestState& state) noexcept { stopSelfTest(state); }
  };

  DeviceLoop<SelfTestState, Tick> loop;
};

SelfTestRun::SelfTestRun() = default;

SelfTestRun::~SelfTestRun()
{
  this->stop();
}

std::string SelfTestRun::start(std::unique_ptr<HapticDevice> device, const SelfTestOptions& options)
{
  this->stop();
  std::string problem = SelfTestPlan::forDevice(device->info(), options.deadMan, options.wheel).refusal();
  if (auto* const holder = dynamic_cast<WallHolder*>(device.get()))
  {
    holder->trust({ true, true }); // to be felt
  }
  if (problem.empty())
  {
    problem = device->open();
  }
  if (!problem.empty())
  {
    return problem;
  }
  // Some devices know their abilities only once they are open.
  this->device_ = device->info();
  if (const auto* linked = dynamic_cast<const LinkedDevice*>(device.get()))
  {
    this->device_.abilities = linked->abilitiesNow();
  }
  this->plan_ = SelfTestPlan::forDevice(this->device_, options.deadMan, options.wheel);
  this->lastState_ = SelfTestState{};
  this->link_ = {};
  const Run::ObligingHand hand(*device);
  this->run_.reset(new Run{ { std::move(device), Run::Tick{ hand, this->plan_ },
    { options.period_s, options.virtualTime, options.brokers } } });
  return {};
}

void SelfTestRun::stop()
{
  if (!this->run_)
  {
    return;
  }
  this->run_->loop.stop();
  this->lastState_ = this->run_->loop.state();
  const auto* const linked = dynamic_cast<const LinkedDevice*>(&this->run_->loop.device());
  this->link_ = linked != nullptr ? linked->linkReport() : LinkReport{};
  this->run_.reset();
}

namespace
{

/// The device itself, also behind a calibration of before.
const PreparedDevice* preparedIn(const HapticDevice& device)
{
  const auto* const calibrated = dynamic_cast<const CalibratedDevice*>(&device);
  return dynamic_cast<const PreparedDevice*>(calibrated != nullptr ? &calibrated->inner() : &device);
}

} // namespace

std::optional<DeviceStep> SelfTestRun::need() const
{
  const PreparedDevice* const prepared = this->run_ ? preparedIn(this->run_->loop.device()) : nullptr;
  return prepared != nullptr ? prepared->step() : std::nullopt;
}

void SelfTestRun::needDone(const std::string& file)
{
  if (const PreparedDevice* const prepared = this->run_ ? preparedIn(this->run_->loop.device()) : nullptr)
  {
    prepared->stepDone(file);
  }
}

void SelfTestRun::step(int ticks)
{
  if (this->run_)
  {
    this->run_->loop.step(ticks);
  }
}

const SelfTestState& SelfTestRun::state()
{
  if (this->run_)
  {
    this->lastState_ = this->run_->loop.state();
  }
  return this->lastState_;
}

} // namespace palpate
