// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/compliance/body/SoftBody.h"

namespace palpate
{

/// About the slowest period that a body of some density swings with around the state it was factored at [s]: Rayleigh's
/// quotient of the shapes that its own weight gives it along each axis, with mass on the nodes; never longer than the
/// truth but for the mesh. A hand that is faster feels inertia, which a body at rest does not have.
[[nodiscard]] double naturalPeriod_s(const SoftBody& body, double density_kg_per_m3, double unit_m);

} // namespace palpate
