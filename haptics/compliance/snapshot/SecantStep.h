// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/compliance/snapshot/ComplianceSnapshot.h"

namespace palpate
{

/// Changes the tangent compliance C of a snapshot so that it leads from the untouched surface to the pressed one.
///
/// Under its forces f, the body has moved by d = C f + e; e vanishes if the body is linear and at rest. The update is
/// that of Broyden, Fletcher, Goldfarb and Shanno for an inverse Hessian:
/// C + d d^T / (f d) - C f (C f)^T / (f C f). It maps f to d, remains symmetric and positive semidefinite, and leaves
/// the answer to forces that do no work on C f as it was. Without forces, or where d does not go with them, which a
/// body that is not at rest yet may do, C stays.
/// `beyond_u`: e of every vertex of the surface.
void takeSecant(const std::vector<Vec3>& beyond_u, ComplianceSnapshot& snapshot);

} // namespace palpate
