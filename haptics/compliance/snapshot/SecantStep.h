// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/compliance/snapshot/ComplianceSnapshot.h"

namespace palpate
{

/// The forces of a snapshot on its places, three numbers each [N].
[[nodiscard]] Eigen::VectorXd loadOnPlaces(const ComplianceSnapshot& snapshot);

/// Changes the tangent compliance C of a snapshot so that it leads from the free surface to the pressed one.
///
/// Under its forces f, the body is displaced by d; d = C f if the body is linear and in equilibrium. The update is that
/// of Broyden, Fletcher, Goldfarb and Shanno for an inverse Hessian: C + d d^T / (f d) - C f (C f)^T / (f C f). The
/// result maps f to d, stays symmetric and positive semidefinite, and answers forces that do no work on C f as before.
/// Without forces, or where f does no positive work on d, as in a body that is not in equilibrium yet, C stays.
/// `moved_u`: d of its places, three numbers each.
void takeSecant(const Eigen::VectorXd& moved_u, ComplianceSnapshot& snapshot);

} // namespace palpate
