// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/devices/hid/ArduinoLibraryModel.h"

#include <algorithm>
#include <cmath>

namespace palpate::test
{
namespace
{

constexpr unsigned directed = 4;

/// In ten thousandths, of a metric in shares, which it compares with numbers in ten thousandths.
double conditionOf(const Condition& told, double metric)
{
  constexpr double all = 10000.0;
  const double low = all * (told.centre - told.deadBand), high = all * (told.centre + told.deadBand);
  if (metric < low)
  {
    return -std::max((metric - low / all) * told.negativeCoefficient, -told.negativeSaturation);
  }
  return metric > high ? -std::min((metric - high / all) * told.positiveCoefficient, told.positiveSaturation) : 0.0;
}

} // namespace

void ArduinoLibraryModel::control(int number)
{
  constexpr int all = 3, reset = 4;
  if (number == all)
  {
    this->stopAll();
  }
  if (number == reset)
  {
    this->wipe();
  }
}

double ArduinoLibraryModel::forceOf(const Effect& effect, std::size_t axis) const
{
  if (effect.axes != directed && (effect.axes >> axis & 1U) == 0)
  {
    return 0.0;
  }
  const bool each = effect.axes == directed && effect.conditionsSeen > 1;
  const double ratio = each ? 1.0 : axis == 0 ? -std::sin(effect.angle_rad) : std::cos(effect.angle_rad);
  if (effect.type != Spring && effect.type != Damper)
  {
    return strength(effect) * ratio;
  }
  return effect.gain * conditionOf(effect.conditions[each ? axis : 0], this->metric(effect, axis)) * ratio;
}

} // namespace palpate::test
