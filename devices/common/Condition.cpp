// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/common/Condition.h"

#include <algorithm>

namespace palpate
{

double conditionForce(const Condition& condition, double m) noexcept
{
  const double above = m - condition.centre - condition.deadBand, below = m - condition.centre + condition.deadBand;
  if (above > 0.0)
  {
    return std::clamp(
      -condition.positiveCoefficient * above, -condition.positiveSaturation, condition.positiveSaturation);
  }
  if (below < 0.0)
  {
    return std::clamp(
      -condition.negativeCoefficient * below, -condition.negativeSaturation, condition.negativeSaturation);
  }
  return 0.0;
}

Condition lowerWall(double edge, double coefficient) noexcept
{
  Condition wall;
  wall.centre = edge;
  wall.negativeCoefficient = coefficient;
  return wall;
}

Condition damper(double coefficient) noexcept
{
  Condition braking;
  braking.positiveCoefficient = coefficient;
  braking.negativeCoefficient = coefficient;
  return braking;
}

Condition corridor(double low, double high, double lowCoefficient, double highCoefficient) noexcept
{
  Condition between;
  between.centre = 0.5 * (low + high);
  between.deadBand = 0.5 * (high - low);
  between.negativeCoefficient = lowCoefficient;
  between.positiveCoefficient = highCoefficient;
  return between;
}

} // namespace palpate
