// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/compliance/body/SoftBody.h"

namespace palpate
{

/// An estimate of the slowest natural period of a body with that density about the state at which it was factored [s]:
/// Rayleigh's quotient of the shapes under its own weight along each axis, with mass on the nodes; never longer than
/// the true period but for the mesh. A faster hand feels inertia, which a quasi-static body does not have.
[[nodiscard]] double naturalPeriod_s(const SoftBody& body, double density_kg_per_m3, double unit_m);

} // namespace palpate
