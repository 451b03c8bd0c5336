// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/mechanism/constraints/ConstraintRows.h"

namespace palpate
{

/// How the body in the hand goes, by the hand's springs, from where its constraints are taken: compliance force + back,
/// whitened. Where the device leaves the turn free, no spring turns it, and the last three are 0.
struct HeldYield
{
  using Square = Eigen::Matrix<double, 6, 6>;

  Square compliance = Square::Zero(); ///< [u/N], symmetric, positive semidefinite
  Vec6 back_u = Vec6::Zero();         ///< without the constraints' forces
  Square eases = Square::Zero();      ///< how the constraints' forces on the body fall as it goes [N/u]
  bool exact = true;                  ///< Newton's: else a step leaves a share of itself
};

/// The springs' second derivatives about the body's pose, and the geometric stiffness: a turned body is turned on by
/// forces that keep their direction at arms that turn with it (Newton's method on the finite rotation). Where those
/// would push it over, a stiffness that is no less than the true one stands for it: steps are then shorter, and end at
/// the same place. Real-time safe.
[[nodiscard]] HeldYield yieldOfHeld(
  const ConstraintScene& scene, const ConstraintRows& rows, const MechanismGrip& grip) noexcept;

} // namespace palpate
