// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "haptics/core/Types.h"

namespace palpate
{

/// m x'' + b x' + k x = u with u held over each period: the exact zero-order-hold step. An Euler step
/// would add damping or energy of its own. Three independent axes.
class LinearPlant
{
public:
  /// One whose state is 0 after a period.
  LinearPlant() = default;
  /// Mass [kg] > 0, damping [N s/m] >= 0, stiffness to the origin [N/m] >= 0, period [s] > 0.
  LinearPlant(double mass_kg, double damping_Ns_per_m, double stiffness_N_per_m, double period_s);

  /// One period under force u [N]. Real-time safe.
  void step(Vec3& x_m, Vec3& v_m_per_s, const Vec3& u_N) const noexcept;

  /// (x, v) after a period without force is free() * (x, v); after one of 1 N from rest it is held().
  [[nodiscard]] const Eigen::Matrix2d& free() const noexcept { return this->free_; }
  [[nodiscard]] const Eigen::Vector2d& held() const noexcept { return this->held_; }

private:
  Eigen::Matrix2d free_ = Eigen::Matrix2d::Zero();
  Eigen::Vector2d held_ = Eigen::Vector2d::Zero();
};

} // namespace palpate
