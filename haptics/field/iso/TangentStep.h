// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/field/iso/IsoRows.h"

namespace palpate
{

/// Newton's step of the proxy along its patches towards the place nearest to the hand: the Lagrangian's Hessian
/// I - sum lambda_i bend_i, seen in the plane or line that the active rows leave free. `y_u`: the projection, whose
/// part along that plane is the gradient there.
[[nodiscard]] Vec3 tangentStep(const IsoRows& rows, const ProjectionResult& y_u) noexcept;

} // namespace palpate
