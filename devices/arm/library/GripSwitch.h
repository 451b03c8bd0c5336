// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace palpate
{

/// A gripper as a switch, which is held while the gripper is closed below half of the widest opening so far. The range
/// of a gripper is not told by its library, so a gripper that has not been opened yet is not held.
class GripSwitch
{
public:
  /// The opening now [rad], negative for a left hand. A number that is no opening is not held and forgotten.
  [[nodiscard]] bool isHeld(double opening_rad) noexcept
  {
    const double open_rad = std::fabs(opening_rad);
    if (!(open_rad <= mostOpening_rad))
    {
      return false;
    }
    // A single number that is too large would make every later one a closed gripper: the widest opening is that of two.
    this->widest_rad_ = std::max(this->widest_rad_, std::min(open_rad, this->before_rad_));
    this->before_rad_ = open_rad;
    return this->widest_rad_ >= leastOpening_rad && open_rad < 0.5 * this->widest_rad_;
  }

private:
  static constexpr double leastOpening_rad = 0.05; ///< less is noise: 3 degrees
  static constexpr double mostOpening_rad = 3.2;   ///< no gripper opens farther than half a turn

  double widest_rad_ = 0.0, before_rad_ = 0.0;
};

} // namespace palpate
