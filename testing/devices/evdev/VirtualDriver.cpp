// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/devices/evdev/VirtualDriver.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <numbers>
#include <utility>

#include "devices/common/Condition.h"

namespace palpate::test
{
namespace
{

/// The kernel's numbers as a condition: its dead band is a whole width, 0xFFFF the whole travel.
Condition conditionFrom(const ff_condition_effect& told)
{
  Condition condition;
  condition.centre = told.center / 32767.0;
  condition.deadBand = told.deadband / 65535.0;
  condition.positiveCoefficient = VirtualDriver::springGain * told.right_coeff / 32767.0;
  condition.negativeCoefficient = VirtualDriver::springGain * told.left_coeff / 32767.0;
  condition.positiveSaturation = told.right_saturation / 65535.0;
  condition.negativeSaturation = told.left_saturation / 65535.0;
  return condition;
}

} // namespace

VirtualDriver::Axes pushedBy(std::uint16_t direction)
{
  const double angle = 2.0 * std::numbers::pi * direction / 65536.0;
  return { -std::sin(angle), std::cos(angle) };
}

int VirtualDriver::upload(ff_effect& effect)
{
  if (effect.type < FF_EFFECT_MIN || effect.type > FF_EFFECT_MAX || !this->traits_.forces[effect.type])
  {
    return EINVAL;
  }
  if (effect.type == FF_PERIODIC && !this->traits_.forces[effect.u.periodic.waveform])
  {
    return EINVAL;
  }
  if (effect.id == -1)
  {
    const auto free =
      std::find_if(this->slots_.begin(), this->slots_.end(), [](const Slot& slot) { return !slot.effect; });
    if (free == this->slots_.end())
    {
      return ENOSPC;
    }
    effect.id = static_cast<std::int16_t>(free - this->slots_.begin());
  }
  else if (effect.id < 0 || effect.id >= static_cast<int>(memory) ||
           !this->slots_[static_cast<std::size_t>(effect.id)].effect ||
           this->slots_[static_cast<std::size_t>(effect.id)].effect->type != effect.type)
  {
    return EINVAL;
  }
  this->store(effect);
  return 0;
}

void VirtualDriver::store(const ff_effect& effect)
{
  Slot& slot = this->slots_.at(static_cast<std::size_t>(effect.id));
  slot.effect = effect;
  slot.played = std::exchange(this->missesNext, false) && slot.plays ? slot.played : effect;
}

int VirtualDriver::erase(int effect)
{
  if (effect < 0 || effect >= static_cast<int>(memory) || !this->slots_[static_cast<std::size_t>(effect)].effect)
  {
    return EINVAL;
  }
  this->slots_[static_cast<std::size_t>(effect)] = {};
  return 0;
}

void VirtualDriver::told(std::uint16_t code, std::int32_t value)
{
  if (code == FF_GAIN)
  {
    this->gain = value;
  }
  else if (code == FF_AUTOCENTER)
  {
    this->autocentre = value;
  }
  else if (code < memory && this->slots_[code].effect)
  {
    Slot& slot = this->slots_[code];
    slot.played = slot.plays ? slot.played : *slot.effect;
    slot.plays = value > 0;
    slot.age_ms = 0;
  }
}

void VirtualDriver::flush()
{
  this->slots_ = {};
}

void VirtualDriver::advance(int duration_ms)
{
  for (int i = 0; i < duration_ms; ++i)
  {
    this->step();
    for (Slot& slot : this->slots_)
    {
      ++slot.age_ms;
      slot.plays = slot.plays && (slot.played.replay.length == 0 || slot.age_ms < slot.played.replay.length);
    }
  }
}

void VirtualDriver::step()
{
  constexpr int parts = 4;
  constexpr double dt_s = 1e-3 / parts;
  for (int part = 0; part < parts; ++part)
  {
    const Axes pulled = this->force();
    for (const std::size_t axis : { 0U, 1U })
    {
      double& v = this->velocity[axis];
      v += dt_s / handleMass * (pulled[axis] + this->push[axis] - handleFriction * v);
      const double free = this->position[axis] + dt_s * v;
      this->position[axis] = std::clamp(free, -1.0, 1.0);
      v = this->position[axis] == free ? v : 0.0;
    }
  }
}

VirtualDriver::Axes VirtualDriver::force() const
{
  Axes sum{};
  for (const std::size_t axis : { 0U, 1U })
  {
    for (const Slot& slot : this->slots_)
    {
      sum[axis] += slot.plays ? this->forceOf(slot, axis) : 0.0;
    }
    sum[axis] = std::clamp(sum[axis], -1.0, 1.0) * this->gain / 65535.0;
  }
  return sum;
}

double VirtualDriver::forceOf(const Slot& slot, std::size_t axis) const
{
  const ff_effect& effect = slot.played;
  switch (effect.type)
  {
    case FF_CONSTANT:
      return (effect.u.constant.level >> 8) / steps * pushedBy(effect.direction)[axis];
    case FF_PERIODIC:
      return effect.u.periodic.magnitude / 32767.0 * pushedBy(effect.direction)[axis] *
             std::sin(2.0 * std::numbers::pi * slot.age_ms / effect.u.periodic.period);
    case FF_SPRING:
      return conditionForce(conditionFrom(effect.u.condition[axis]), this->position[axis]);
    case FF_DAMPER:
      return conditionForce(conditionFrom(effect.u.condition[axis]), damperMetric * this->velocity[axis]);
    default:
      return 0.0;
  }
}

int VirtualDriver::held() const
{
  return static_cast<int>(
    std::count_if(this->slots_.begin(), this->slots_.end(), [](const Slot& slot) { return slot.effect.has_value(); }));
}

int VirtualDriver::playing() const
{
  return static_cast<int>(
    std::count_if(this->slots_.begin(), this->slots_.end(), [](const Slot& slot) { return slot.plays; }));
}

const ff_effect* VirtualDriver::of(std::uint16_t type) const
{
  const auto it = std::find_if(this->slots_.begin(), this->slots_.end(),
    [type](const Slot& slot) { return slot.effect && slot.effect->type == type; });
  return it == this->slots_.end() ? nullptr : &*it->effect;
}

} // namespace palpate::test
