// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/mechanism/servo/SettledConstraints.h"

namespace palpate
{

/// Soft bodies return no more energy to loose bodies than they were given. Snapshots are late: as one takes the place
/// of another, the same depth has another force, and an offset that fades lifts the body that lies there. At the end of
/// a tick the work of all contacts on soft bodies is added up, and is no more than the energy that the tick's
/// compliance holds. Where that holds more than was given, a loose body that is pushed away takes over only that share
/// of the push, and otherwise goes slowly. `before_W`: of the bodies before the tick; `state` has them after it, with
/// the forces. Real-time safe.
void returnNoMore(const MechanismPlan& plan, const SettledConstraints& laws, const PosesOfBodies& before_W, double dt_s,
  MechanismState& state) noexcept;

} // namespace palpate
