// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/mechanism/MechanismPlan.h"

namespace palpate
{

/// How far a constraint has come.
enum class ConstraintPhase : std::uint8_t
{
  Open,   ///< holds nothing now: a contact that is open, a needle that has not met its body
  Closed, ///< holds
  Slips,  ///< holds as much as its friction lets it
  Inside, ///< the shaft is in its hole
  Gone,   ///< broken: it holds nothing any more
};

/// State of a constraint between ticks.
struct ConstraintState
{
  ConstraintPhase phase = ConstraintPhase::Open;
  bool met = false;              ///< Puncture: the tip is at the surface
  bool seen = false;             ///< it had rows in the tick before
  bool waits = false;            ///< the held body has not come yet to where the constraint holds without breaking at
                                 ///< once
  bool placed = false;           ///< `stuck_u` has been set
  SurfacePoint place_A;          ///< where the constraint is on a soft body
  SurfacePoint place_B;          ///< likewise
  Vec3 normal_W = Vec3::UnitZ(); ///< Puncture: of the surface where the tip is
  Vec3 stuck_u = Vec3::Zero();   ///< friction: from B's point to A's where it would rest; dry: along its axis in x
  Vec3 force_W = Vec3::Zero();   ///< on A [N]
  Vec3 offset_W = Vec3::Zero();  ///< of A's point against B's: the jump by a new snapshot, taken back and fading
  Vec3 apart_W = Vec3::Zero();   ///< displacement by soft bodies between the points, without that offset
};

} // namespace palpate
