// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "haptics/mechanism/constraints/ConstraintRows.h"

namespace palpate
{

/// A constraint changed for good, or for as long as the needle is in: a recording names it by the tick.
enum class ConstraintChange : std::uint8_t
{
  Punctured,
  Withdrawn, ///< the tip came out of its hole: the next one is punctured anew
  Broken,    ///< an attachment that was pulled at with more than its strength
  TornOut,   ///< a shaft that was pulled across its hole with more than that holds
};

/// The outcome of the rows of one constraint.
struct ConstraintOutcome
{
  Vec3 force_W = Vec3::Zero(); ///< on A [N]
  Vec3 rest_u = Vec3::Zero();  ///< where its friction would let it rest from now on, as ConstraintState::stuck_u
  double push_N = 0.0;         ///< of a row that only pushes
  double across_N = 0.0;       ///< on a shaft
  bool holds = false;          ///< a row has force
  bool slips = false;
};

[[nodiscard]] ConstraintOutcome outcomeOf(
  const ConstraintScene& scene, const ConstraintRows& rows, const ConstraintForces& forces, int law) noexcept;

/// Whether a constraint of this kind holds from the beginning and may be pulled away: the held body may begin
/// elsewhere.
[[nodiscard]] bool mayGiveWay(const PlannedConstraint& law) noexcept;

/// Whether a constraint of that kind, or a shaft in its hole, breaks under this.
[[nodiscard]] bool givesWay(const PlannedConstraint& law, const ConstraintOutcome& outcome) noexcept;

/// The change that the outcome makes to a constraint, if any; the state is changed.
[[nodiscard]] std::optional<ConstraintChange> changeConstraint(
  const PlannedConstraint& law, const ConstraintOutcome& outcome, ConstraintState& state) noexcept;

} // namespace palpate
