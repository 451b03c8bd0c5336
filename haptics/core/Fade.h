// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace palpate
{

/// The share that is left of a step of a force or of an offset, so that the hand never feels a change at once.
/// `time_s`: the time in which the step fades. Each formula is the one that recordings were made with.
struct Fade
{
  double time_s = 0.0;

  /// The share of an exponential decay that a tick leaves, by an implicit step: above 0 however long the tick is. 0 if
  /// nothing is to fade.
  [[nodiscard]] constexpr double implicitShare(double dt_s) const noexcept
  {
    return this->time_s > 0.0 ? this->time_s / (this->time_s + dt_s) : 0.0;
  }
  /// Likewise by an explicit step: 0 after a tick that is longer than the time.
  [[nodiscard]] constexpr double explicitShare(double dt_s) const noexcept
  {
    return std::max(1.0 - dt_s / this->time_s, 0.0);
  }
  /// The share of a linear ramp that has so long to go.
  [[nodiscard]] constexpr double linearShare(double left_s) const noexcept { return left_s / this->time_s; }
};

} // namespace palpate
