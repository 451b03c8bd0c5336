// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "haptics/core/Types.h"

namespace palpate
{

/// A position that stays the same to the last bit while there is a force: a hand holds very still, or the device no
/// longer measures. Not a fault: it is said.
struct PositionWatch
{
  static constexpr double frozenAfter_s = 0.25;
  static constexpr double counts = 0.2; ///< a smaller part of a device's largest force does not count
  static constexpr double never = std::numeric_limits<double>::infinity();

  double same_s = 0.0; ///< for how long it has been the same under force

  /// `above_N`: a smaller force does not count. Returns whether it is frozen.
  /// Real-time safe.
  [[nodiscard]] bool look(const Vec3& p_D, const Vec3& before_D, double force_N, double above_N, double dt_s) noexcept
  {
    this->same_s = p_D == before_D && force_N > above_N ? this->same_s + dt_s : 0.0;
    return this->same_s > frozenAfter_s;
  }
};

} // namespace palpate
