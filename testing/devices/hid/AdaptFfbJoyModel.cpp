// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/devices/hid/AdaptFfbJoyModel.h"

#include <cmath>

#include "testing/devices/hid/VirtualPidDevice.h"

namespace palpate::test
{
namespace
{

ModelWire adapterWire()
{
  ModelWire wire;
  wire.turn = 180;
  wire.forces = 255.0;
  wire.oneCoefficient = true;
  wire.firstBlock = 2;
  wire.blocks = 16;
  return wire;
}

} // namespace

AdaptFfbJoyModel::AdaptFfbJoyModel(std::span<const std::uint8_t> descriptor) : FirmwareModel(descriptor, adapterWire())
{
}

void AdaptFfbJoyModel::tick(Effect& effect)
{
  constexpr int none = 0xFF;
  const bool bound = effect.used && effect.trigger != none && effect.trigger < 8;
  const bool down = bound && (this->buttons >> effect.trigger & 1U) != 0;
  if (down && !effect.held)
  {
    effect.playing = true;
    effect.age_ms = 0;
  }
  effect.held = down;
}

void AdaptFfbJoyModel::control(int number)
{
  enum
  {
    Enable = 1,
    Disable,
    StopAll,
    Reset
  };
  this->on_ = number != Disable && (this->on_ || number == Enable || number == Reset);
  if (number == StopAll)
  {
    this->stopAll();
    this->centring_ = false;
  }
  if (number == Reset)
  {
    this->wipe();
    this->centring_ = true;
  }
}

double AdaptFfbJoyModel::forceOf(const Effect& effect, std::size_t axis) const
{
  if (effect.type != Spring && effect.type != Damper)
  {
    return strength(effect) * (axis == 0 ? -std::sin(effect.angle_rad) : std::cos(effect.angle_rad));
  }
  return VirtualPidDevice::springGain * conditionForce(effect.conditions[axis], this->metric(effect, axis));
}

double AdaptFfbJoyModel::ownForce(std::size_t axis) const
{
  return this->centring_ && this->on_ ? -VirtualPidDevice::centringGain * this->position[axis] : 0.0;
}

} // namespace palpate::test
