// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/devices/hid/OpenFFBoardModel.h"

#include <cmath>

#include "testing/devices/hid/VirtualPidDevice.h"

namespace palpate::test
{
namespace
{

bool pushes(const Condition& c)
{
  return (c.positiveCoefficient != 0.0 && c.positiveSaturation != 0.0) ||
         (c.negativeCoefficient != 0.0 && c.negativeSaturation != 0.0);
}

ModelWire boardWire()
{
  ModelWire wire{ 0x11, 0x12, 0x13, true, 2, 36000, 32767.0, 32767.0 };
  wire.blocks = 40;
  return wire;
}

} // namespace

OpenFFBoardModel::OpenFFBoardModel(std::span<const std::uint8_t> descriptor) : FirmwareModel(descriptor, boardWire()) {}

void OpenFFBoardModel::settingsCame(Effect& effect)
{
  constexpr unsigned x = 1, y = 2, directed = 4;
  const bool isCondition = effect.type >= Spring && !effect.sameForBoth;
  const bool first = isCondition && pushes(effect.conditions[0]), second = isCondition && pushes(effect.conditions[1]);
  if (first || second)
  {
    effect.factors = { first ? 1.0 : effect.factors[0], second ? 1.0 : effect.factors[1] };
  }
  else if ((effect.axes & directed) != 0)
  {
    effect.factors = { std::sin(effect.angle_rad), -std::cos(effect.angle_rad) };
  }
  else
  {
    const double linear = effect.angle_rad / M_PI - 1.0;
    effect.factors = { (effect.axes & x) != 0 ? linear : 0.0, (effect.axes & y) != 0 ? -linear : 0.0 };
  }
  this->on_ = true;
}

void OpenFFBoardModel::conditionCame(Effect& effect, std::size_t axis)
{
  const bool counts = pushes(effect.conditions[axis]);
  effect.sameForBoth = effect.sameForBoth && !(axis > 0 && counts);
  if ((counts || (axis > 0 && effect.sameForBoth)) && effect.factors[axis] == 0.0)
  {
    effect.factors[axis] = 1.0;
  }
}

void OpenFFBoardModel::control(int number)
{
  const auto bits = static_cast<unsigned>(number);
  this->on_ = (bits & 1U) != 0 || (this->on_ && (bits & (2U | 4U | 8U)) == 0);
  if ((bits & 8U) != 0)
  {
    this->wipe();
  }
}

double OpenFFBoardModel::forceOf(const Effect& effect, std::size_t axis) const
{
  if (effect.type != Spring && effect.type != Damper)
  {
    return -strength(effect) * effect.factors[axis];
  }
  Condition scaled = effect.conditions[effect.sameForBoth ? 0 : axis];
  scaled.positiveCoefficient *= VirtualPidDevice::springGain;
  scaled.negativeCoefficient *= VirtualPidDevice::springGain;
  return conditionForce(scaled, this->metric(effect, axis)) * effect.factors[axis];
}

} // namespace palpate::test
