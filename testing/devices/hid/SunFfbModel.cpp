// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/devices/hid/SunFfbModel.h"

#include <cmath>

#include "testing/devices/hid/VirtualPidDevice.h"

namespace palpate::test
{
namespace
{

constexpr unsigned directed = 4;
constexpr int noTrigger = 0xFF;

ModelWire simulatorWire()
{
  ModelWire wire;
  wire.directionBytes = 2;
  wire.turn = 36000;
  return wire;
}

Condition scaled(Condition condition)
{
  condition.positiveCoefficient *= VirtualPidDevice::springGain;
  condition.negativeCoefficient *= VirtualPidDevice::springGain;
  return condition;
}

} // namespace

SunFfbModel::SunFfbModel(std::span<const std::uint8_t> descriptor) : FirmwareModel(descriptor, simulatorWire()) {}

void SunFfbModel::started(Effect& effect)
{
  effect.playing = effect.trigger == noTrigger;
}

void SunFfbModel::tick(Effect& effect)
{
  const bool down = effect.trigger >= 1 && effect.trigger <= 8 && (this->buttons >> (effect.trigger - 1) & 1U) != 0;
  effect.playing = effect.playing || (effect.used && down && !effect.held);
  effect.held = down;
}

void SunFfbModel::control(int number)
{
  enum
  {
    Enable = 1,
    Disable,
    StopAll,
    Reset
  };
  this->on_ = number == Enable || number == Reset || (this->on_ && number != Disable);
  if (number == StopAll)
  {
    this->stopAll();
  }
  if (number == Reset)
  {
    this->wipe();
  }
}

double SunFfbModel::forceOf(const Effect& effect, std::size_t axis) const
{
  const Axes along{ -std::sin(effect.angle_rad), std::cos(effect.angle_rad) };
  const bool both = (effect.axes & directed) != 0, acts = both || (effect.axes >> axis & 1U) != 0;
  if (effect.type != Spring && effect.type != Damper)
  {
    return acts ? strength(effect) * along[axis] : 0.0;
  }
  if (both && effect.conditionsSeen <= 1)
  {
    const double m = this->metric(effect, 0) * along[0] + this->metric(effect, 1) * along[1];
    return conditionForce(scaled(effect.conditions[0]), m) * along[axis];
  }
  return acts ? effect.gain * conditionForce(scaled(effect.conditions[axis]), this->metric(effect, axis)) : 0.0;
}

} // namespace palpate::test
