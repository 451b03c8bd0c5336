// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/core/Types.h"

namespace palpate::test
{

/// The mechanics of an arm whose tip a hand leads exactly, written apart from the product's: by differences of the
/// place of the tip alone. Planar arms have a third joint that moves the tip along z and has no motor.
class LedArm
{
public:
  virtual ~LedArm() = default;

  /// Where the tip is with these joints [m, rad].
  [[nodiscard]] virtual Vec3 tipOf(const Vec3& joints_rad) const = 0;

  void place(const Vec3& joints_rad) { this->joints_rad_ = joints_rad; }
  /// Newton's method from where it is. False: it does not get there.
  bool lead(const Vec3& tip_m);
  [[nodiscard]] const Vec3& joints_rad() const noexcept { return this->joints_rad_; }
  [[nodiscard]] Vec3 tip_m() const { return this->tipOf(this->joints_rad_); }
  /// Force on the hand for torques of the joints, by virtual work [N].
  [[nodiscard]] Vec3 forceOf(const Vec3& torque_Nm) const;
  /// Columns: the tip's way over each joint [m/rad].
  [[nodiscard]] Mat3 ways() const;

private:
  Vec3 joints_rad_ = Vec3::Zero();
};

} // namespace palpate::test
