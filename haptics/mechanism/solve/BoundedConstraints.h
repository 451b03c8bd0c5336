// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/compliance/servo/BoundedRows.h"
#include "haptics/mechanism/solve/ConstraintProblem.h"

namespace palpate
{

/// All rows that have bounds; the share of cones and degrees of freedom in their gaps is known.
struct BoundedConstraints
{
  static constexpr int most = ConstraintProblem::most;

  const ConstraintProblem& problem;
  const ConstraintScratch& room;

  [[nodiscard]] int count() const noexcept { return this->problem.bounded(); }
  [[nodiscard]] double compliance(int i, int j) const noexcept { return this->room.stiffened(i, j); }
  [[nodiscard]] double free(int i) const noexcept { return this->room.pressed[i]; }
  [[nodiscard]] double lowest(int i) const noexcept { return this->problem.lowest[i]; }
  [[nodiscard]] double highest(int i) const noexcept { return this->problem.highest[i]; }
};
using ActiveConstraints = BoundedRows<BoundedConstraints>;

} // namespace palpate
