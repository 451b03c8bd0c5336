// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/compliance/snapshot/ComplianceSnapshot.h"

namespace palpate
{

/// The forces of a snapshot on its places, three numbers each [N].
[[nodiscard]] Eigen::VectorXd loadOnPlaces(const ComplianceSnapshot& snapshot);

/// Changes the tangent compliance C of a snapshot so that it leads from the untouched surface to the pressed one.
///
/// Under its forces f, the body has moved by d; d = C f if the body is linear and at rest. The update is that of
/// Broyden, Fletcher, Goldfarb and Shanno for an inverse Hessian: C + d d^T / (f d) - C f (C f)^T / (f C f). It maps f
/// to d, remains symmetric and positive semidefinite, and leaves the answer to forces that do no work on C f as it was.
/// Without forces, or where d does not go with them, which a body that is not at rest yet may do, C stays.
/// `moved_u`: d of its places, three numbers each.
void takeSecant(const Eigen::VectorXd& moved_u, ComplianceSnapshot& snapshot);

} // namespace palpate
