// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/mechanism/MechanismPlan.h"

namespace palpate
{

/// Whether a body of a plan is a mesh that stands: other bodies that do not move have no extent.
[[nodiscard]] inline bool isStandingMesh(const PlannedBody& body) noexcept
{
  return body.kind == MechanismBodyKind::World && body.low_u != body.high_u;
}

} // namespace palpate
