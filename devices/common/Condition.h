// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

namespace palpate
{

/// A condition in the device's own loop along one axis: a spring over position, a damper over velocity, friction over
/// the sign of velocity. The condition block of the USB Physical Interface Devices class 1.0; the same as DirectInput's
/// and Apple's.
///
/// `deadBand` is counted from the centre to either side, in the unit of the metric. Linux and SDL count the whole width
/// instead: twice as much. A conversion of a corridor must halve its width.
struct Condition
{
  static constexpr double unlimited = std::numeric_limits<double>::infinity();

  double centre = 0.0;
  double deadBand = 0.0;                 ///< half the width without force, >= 0
  double positiveCoefficient = 0.0;      ///< beyond the dead band's upper end; positive ones push back
  double negativeCoefficient = 0.0;      ///< beyond the lower end
  double positiveSaturation = unlimited; ///< largest force there, >= 0
  double negativeSaturation = unlimited;
};

/// The force of a condition where the metric (position, velocity, ...) is m:
///
///     m > centre + deadBand:  -positiveCoefficient (m - centre - deadBand)
///     m < centre - deadBand:  -negativeCoefficient (m - centre + deadBand)
///
/// cut to the saturation of its side. One formula for conversions to conditions and for models of devices. Real-time
/// safe.
[[nodiscard]] double conditionForce(const Condition& condition, double m) noexcept;

/// The condition that keeps the metric at or above `edge`, pushing with `coefficient` per unit below it.
[[nodiscard]] Condition lowerWall(double edge, double coefficient) noexcept;

/// The condition that brakes a velocity with `coefficient` per unit.
[[nodiscard]] Condition damper(double coefficient) noexcept;

/// The corridor from `low` to `high`, low <= high, with a wall at each end.
[[nodiscard]] Condition corridor(double low, double high, double lowCoefficient, double highCoefficient) noexcept;

} // namespace palpate
