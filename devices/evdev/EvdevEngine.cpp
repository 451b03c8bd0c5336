// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/evdev/EvdevEngine.h"

#include <algorithm>
#include <cmath>

#include "devices/hid/pid/PidEngine.h"

namespace palpate
{
namespace
{

constexpr double largestSigned = 0x7FFF, largestUnsigned = 0xFFFF;
constexpr int everything = 0xFFFF;

std::int16_t signedOf(double share) noexcept
{
  return static_cast<std::int16_t>(std::lround(std::clamp(share, -1.0, 1.0) * largestSigned));
}

std::uint16_t unsignedOf(double share) noexcept
{
  return static_cast<std::uint16_t>(std::lround(std::clamp(share, 0.0, 1.0) * largestUnsigned));
}

std::uint16_t wholeMilliseconds(double time_ms) noexcept
{
  return static_cast<std::uint16_t>(std::lround(std::clamp(time_ms, 1.0, largestUnsigned)));
}

/// A whole turn is 0x10000, counted as PID counts it.
std::uint16_t directionOf(const EffectSettings& settings) noexcept
{
  return static_cast<std::uint16_t>(std::lround(settings.comesFrom_deg * 65536.0 / 360.0));
}

std::optional<std::uint16_t> typeOf(HidUsage type) noexcept
{
  switch (type)
  {
    case pid::constantForce:
      return FF_CONSTANT;
    case pid::spring:
      return FF_SPRING;
    case pid::damper:
      return FF_DAMPER;
    case pid::sine:
      return FF_PERIODIC;
    default:
      return std::nullopt;
  }
}

/// The kernel's dead band is a whole width, 0xFFFF all of the travel; ours is half of it, 1 half of the travel.
ff_condition_effect conditionOf(const Condition& condition) noexcept
{
  ff_condition_effect told{};
  told.center = signedOf(condition.centre);
  told.deadband = unsignedOf(condition.deadBand);
  told.right_coeff = signedOf(condition.positiveCoefficient);
  told.left_coeff = signedOf(condition.negativeCoefficient);
  told.right_saturation = unsignedOf(condition.positiveSaturation);
  told.left_saturation = unsignedOf(condition.negativeSaturation);
  return told;
}

/// One that does nothing yet, and ends by itself.
ff_effect emptyOf(std::uint16_t type) noexcept
{
  ff_effect effect{};
  effect.type = type;
  effect.id = -1;
  effect.replay.length = wholeMilliseconds(EffectSettings{}.duration_ms);
  if (type == FF_PERIODIC)
  {
    effect.u.periodic.waveform = FF_SINE;
    effect.u.periodic.period = 1;
  }
  return effect;
}

} // namespace

EvdevEngine::EvdevEngine(EvdevConnection& connection, const EvdevTraits& traits) noexcept
  : connection_(connection), traits_(traits)
{
}

std::string EvdevEngine::open()
{
  this->effects_.clear();
  this->ownSpring_ = this->connection_.setting("autocenter");
  const bool taken = (!this->traits_.forces[FF_GAIN] || this->connection_.tell(FF_GAIN, everything)) &&
                     (!this->traits_.forces[FF_AUTOCENTER] || this->connection_.tell(FF_AUTOCENTER, 0));
  return taken ? "" : "the device rejects commands: " + this->connection_.error();
}

void EvdevEngine::close() noexcept
{
  static_cast<void>(this->control(pid::stopAll));
  for (const Effect& effect : this->effects_)
  {
    static_cast<void>(this->connection_.erase(effect.told.id));
  }
  this->effects_.clear();
  if (this->ownSpring_ && this->traits_.forces[FF_AUTOCENTER])
  {
    static_cast<void>(this->connection_.tell(FF_AUTOCENTER, std::clamp(*this->ownSpring_, 0, everything)));
  }
}

EffectEngine::Created EvdevEngine::create(HidUsage type)
{
  const std::optional<std::uint16_t> kernels = typeOf(type);
  Effect effect;
  effect.told = emptyOf(kernels.value_or(0));
  if (!kernels || this->connection_.upload(effect.told) != EvdevTaken::Yes)
  {
    return { 0, "the device rejects a new effect: " + this->connection_.error() };
  }
  this->effects_.push_back(effect);
  return { static_cast<int>(this->effects_.size()), "" };
}

bool EvdevEngine::setEffect(int block, const EffectSettings& settings) noexcept
{
  ff_effect& told = this->at(block).told;
  told.direction = directionOf(settings);
  told.replay.length = wholeMilliseconds(settings.duration_ms);
  return this->give(this->at(block));
}

bool EvdevEngine::setCondition(int block, int axis, const Condition& condition) noexcept
{
  this->at(block).told.u.condition[axis] = conditionOf(condition);
  return this->give(this->at(block));
}

bool EvdevEngine::setConstantForce(int block, double share) noexcept
{
  this->at(block).told.u.constant.level = signedOf(share);
  return this->give(this->at(block));
}

bool EvdevEngine::setPeriodic(int block, double magnitude, double period_ms) noexcept
{
  this->at(block).told.u.periodic.magnitude = signedOf(magnitude);
  this->at(block).told.u.periodic.period = wholeMilliseconds(period_ms);
  return this->give(this->at(block));
}

bool EvdevEngine::start(int block) noexcept
{
  Effect& effect = this->at(block);
  return this->give(effect) && this->connection_.tell(static_cast<std::uint16_t>(effect.told.id), 1);
}

bool EvdevEngine::stop(int block) noexcept
{
  return this->connection_.tell(static_cast<std::uint16_t>(this->at(block).told.id), 0);
}

bool EvdevEngine::control(HidUsage what) noexcept
{
  bool taken = true;
  for (std::size_t block = 1; what == pid::stopAll && block <= this->effects_.size(); ++block)
  {
    taken = this->stop(static_cast<int>(block)) && taken;
  }
  return taken;
}

std::int64_t EvdevEngine::constantForceSteps(double share) const noexcept
{
  return signedOf(share);
}

bool EvdevEngine::give(Effect& effect) noexcept
{
  const EvdevTaken taken = this->connection_.upload(effect.told);
  effect.late = taken == EvdevTaken::Later;
  return taken != EvdevTaken::No;
}

PidStep EvdevEngine::catchUp() noexcept
{
  const auto late = std::find_if(this->effects_.begin(), this->effects_.end(), [](const Effect& e) { return e.late; });
  if (late == this->effects_.end())
  {
    return PidStep::Idle;
  }
  const bool taken = this->give(*late);
  return taken && late->late ? PidStep::Idle : sentOrFailed(taken);
}

} // namespace palpate
