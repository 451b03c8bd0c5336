// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/mechanism/solve/ConstraintProblem.h"

namespace palpate
{

/// Whether the free bodies find no rest: a displacement is a certificate of that, along which the loads do more work
/// than all forces together that the constraints allow can take up (Farkas' lemma; of Coulomb's friction the kinematic
/// theorem of limit analysis, which needs a displacement that opens each contact by its friction). The displacement is
/// looked for near `guess`, along which the body slips, say: as its projection on all displacements that nothing
/// resists without bounds (Boyle & Dykstra 1986). True is a proof that no forces below 1e5 times the load balance it;
/// false says nothing. `work` is added to, in the unit of ContactPlan::workBudget. Real-time safe.
[[nodiscard]] bool isEndless(
  const ConstraintProblem& problem, const ConstraintProblem::Way& guess, std::uint32_t& work) noexcept;

} // namespace palpate
