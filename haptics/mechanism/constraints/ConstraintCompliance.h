// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/mechanism/constraints/HeldYield.h"

namespace palpate
{

/// The problem of these rows: W = sum J C J^T over the held body's springs, loose bodies, soft bodies and the
/// constraints' own springs. Real-time safe.
void assembleConstraints(const ConstraintScene& scene, const ConstraintRows& rows, const MechanismGrip& grip,
  const HeldYield& held, ConstraintProblem& problem) noexcept;

/// Displacement that soft bodies put between the points of constraint l, B's to A's, under the constraints' forces in
/// their states [u].
[[nodiscard]] Vec3 softApart_W(const ConstraintScene& scene, const ConstraintRows& rows, int l) noexcept;

/// Where the soft body of a side has yielded to at its point of constraint l, likewise.
[[nodiscard]] Vec3 yielded_W(const ConstraintScene& scene, const ConstraintRows& rows, int l, int side) noexcept;

/// The small motion of a body under the forces of the constraints, whitened, from where the constraints are linearised.
[[nodiscard]] Vec6 motionOf(const ConstraintScene& scene, const ConstraintRows& rows, const MechanismGrip& grip,
  const HeldYield& held, const ConstraintForces& forces, int body) noexcept;

/// The constraints' forces on a body about its origin, whitened: the moment over the lever [N].
[[nodiscard]] Vec6 pressOn(
  const ConstraintScene& scene, const ConstraintRows& rows, const ConstraintForces& forces, int body) noexcept;

} // namespace palpate
