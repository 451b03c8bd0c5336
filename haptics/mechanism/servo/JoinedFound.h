// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/mechanism/servo/MechanismState.h"

namespace palpate
{

/// The plan with the contacts that were found behind its own constraints, as more of them. Contacts that have no room
/// are left out. `pose_W`: of the bodies now. Where a face of the mesh in the hand meets a vertex that stands, the
/// contact's plane turns with the mesh. `rest_u`: that mesh is kept so far from meshes that stand. Real-time safe.
void joinFound(const MechanismPlan& plan, const FoundContacts& found, const PosesOfBodies& pose_W,
  MechanismPlan& joined, double rest_u) noexcept;

/// Takes another answer into the state, whose constraints from `named` on are those of the answer before. A contact of
/// the same features, or else of a place nearby, goes on with the force and the slip of the one before, though its
/// points are others. `pose_W`: of the bodies now. Real-time safe.
void takeFound(const FoundContacts& found, int named, const PosesOfBodies& pose_W, MechanismState& state) noexcept;

} // namespace palpate
