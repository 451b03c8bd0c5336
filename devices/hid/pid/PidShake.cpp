// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/hid/pid/PidShake.h"

#include <cmath>
#include <utility>

#include "haptics/core/Clock.h"

namespace palpate
{
namespace
{

constexpr double shake_ms = 20.0;
constexpr double signalShare = 0.3;
constexpr double felt = 0.01; ///< a smaller change of strength is not sent

} // namespace

EffectSettings PidShake::settings() const noexcept
{
  EffectSettings settings;
  settings.type = this->type_;
  settings.duration_ms = this->timing_.duration_ms;
  return settings;
}

std::string PidShake::begin(HidUsage type)
{
  this->type_ = type;
  const EffectEngine::Created made = this->engine_.create(type);
  if (!made.problem.empty())
  {
    return made.problem;
  }
  if (!this->engine_.setEffect(made.value, this->settings()))
  {
    return "the device rejects the settings of an effect";
  }
  this->block_ = made.value;
  return {};
}

void PidShake::forget() noexcept
{
  this->started_ns_ = never;
  this->sends_ = false;
}

bool PidShake::setStrength(const Vibration& vibration) noexcept
{
  return this->type_ == pid::constantForce
           ? this->engine_.setConstantForce(this->block_, vibration.share)
           : this->engine_.setPeriodic(this->block_, vibration.share, vibration.period_ms);
}

PidStep PidShake::play(Signal signal) noexcept
{
  const bool isNew = signal != this->lastSignal_;
  this->lastSignal_ = signal;
  if (signal == Signal::None)
  {
    return this->end();
  }
  if (isNew && this->exists())
  {
    this->sends_ = true;
    this->part_ = 0;
  }
  if (!this->sends_)
  {
    return PidStep::Idle;
  }
  switch (this->part_++)
  {
    case 0:
      return sentOrFailed(this->engine_.setEffect(this->block_, this->settings()));
    case 1:
      return sentOrFailed(this->setStrength({ signalShare, shake_ms }));
    default:
      this->sends_ = false;
      this->begun_ = true;
      return sentOrFailed(this->engine_.start(this->block_));
  }
}

/// Its end is not watched: to stop it again does nothing.
PidStep PidShake::end() noexcept
{
  this->sends_ = false;
  return std::exchange(this->begun_, false) ? sentOrFailed(this->engine_.stop(this->block_)) : PidStep::Idle;
}

PidStep PidShake::vibrate(std::int64_t now_ns, const Vibration& wanted) noexcept
{
  const auto since = [now_ns](std::int64_t then_ns, int limit_ms)
  { return then_ns == never || now_ns - then_ns >= limit_ms * perMs_ns; };
  const bool wants = wanted.share > 0.0, has = this->sent_.share > 0.0;
  const bool other =
    wants != has || std::fabs(wanted.share - this->sent_.share) >= felt || wanted.period_ms != this->sent_.period_ms;
  // Where it begins or ends is not made to wait.
  if (other && (wants != has || since(this->changed_ns_, this->timing_.changeEvery_ms)))
  {
    this->sent_ = wanted;
    this->changed_ns_ = now_ns;
    return sentOrFailed(this->setStrength(wanted));
  }
  if (has && since(this->started_ns_, this->timing_.restartEvery_ms))
  {
    this->restarts_ += this->started_ns_ != never ? 1 : 0;
    this->started_ns_ = now_ns;
    return sentOrFailed(this->engine_.start(this->block_));
  }
  if (!wants && !has && this->started_ns_ != never)
  {
    this->started_ns_ = never;
    return sentOrFailed(this->engine_.stop(this->block_));
  }
  return PidStep::Idle;
}

} // namespace palpate
