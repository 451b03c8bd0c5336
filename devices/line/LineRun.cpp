// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/line/LineRun.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "haptics/force/StabilityLimits.h"
#include "haptics/session/DeviceAdaptation.h"

namespace palpate
{

struct LineRun::Run
{
  /// The tick of a line, with the owner's requests.
  struct Tick
  {
    LineWorld world;
    SafetyLimits limits;
    std::shared_ptr<std::atomic<bool>> asked = std::make_shared<std::atomic<bool>>(false);

    static void before(double, const LineState&) noexcept {}
    DeviceCommand step(const DeviceSample& sample, DeviceStatus status, double dt_s, LineState& state) const noexcept
    {
      return stepLine(this->world, this->limits, { sample, status, this->asked->exchange(false), dt_s }, state);
    }
    static bool goesOn(const LineState&) noexcept { return true; }
    static void end(LineState& state) noexcept { state.force_N = state.gain = 0.0; }
  };

  std::shared_ptr<std::atomic<bool>> asked;
  DeviceLoop<LineState, Tick> loop;
};

LineRun::LineRun() = default;

LineRun::~LineRun()
{
  this->stop();
}

std::string LineRun::start(
  std::unique_ptr<HapticDevice> device, LineWorld world, const DeadMan& deadMan, const DeviceLoopOptions& options)
{
  this->stop();
  const DeviceInfo& info = device->info();
  const bool pushes = info.rendersForce && info.deviceClass != DeviceClass::Vibration0D;
  HapticParameters plain;
  plain.passivity.enabled = false; // nothing takes back the excess of a held force
  const LoopSettings loop = loopSettings(plain, options.period_s);
  const double largest_N_per_m = pushes ? stabilityLimits(info, loop).largest_N_per_m : 0.0;
  std::string problem =
    pushes ? world.refusal(largest_N_per_m) : "a path needs a force-feedback device, and this device renders no force";
  if (problem.empty())
  {
    problem = device->open();
  }
  if (!problem.empty())
  {
    return problem;
  }
  Run::Tick tick{ std::move(world), SafetyLimits::forDevice(info) };
  tick.limits.deadMan = deadMan;
  this->lastState_ = {};
  std::shared_ptr<std::atomic<bool>> asked = tick.asked;
  this->run_.reset(new Run{ std::move(asked), { std::move(device), std::move(tick), options } });
  return {};
}

void LineRun::engage() noexcept
{
  if (this->run_)
  {
    *this->run_->asked = true;
  }
}

void LineRun::stop()
{
  if (this->run_)
  {
    this->run_->loop.stop();
    this->lastState_ = this->run_->loop.state();
    this->run_.reset();
  }
}

void LineRun::step(int ticks)
{
  if (this->run_)
  {
    this->run_->loop.step(ticks);
  }
}

const LineState& LineRun::state()
{
  if (this->run_)
  {
    this->lastState_ = this->run_->loop.state();
  }
  return this->lastState_;
}

} // namespace palpate
