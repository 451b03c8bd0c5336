// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <type_traits>

#include "haptics/mechanism/FoundContacts.h"
#include "haptics/mechanism/constraints/ConstraintState.h"
#include "haptics/mechanism/constraints/LooseYield.h"
#include "haptics/mechanism/servo/HandLead.h"
#include "haptics/mechanism/wire/WireTick.h"
#include "haptics/tool/servo/ToolBlend.h"

namespace palpate
{

using PosesOfBodies = std::array<Pose, Mechanism::mostBodies>; ///< in the plan's order

/// Energy of the soft bodies of a mechanism (SoftReturn.h).
struct SoftEnergy
{
  double given_Nu = 0.0; ///< by work on them, less their own and their losses
  double held_Nu = 0.0;  ///< elastic, by the compliance of the last tick
};

/// State of a mechanism between ticks.
struct MechanismState
{
  std::uint64_t revision = 0;                                     ///< of the plan
  std::array<std::uint64_t, Mechanism::mostBodies> snapshot{};    ///< revisions of the soft bodies' snapshots
  PosesOfBodies pose_W{};                                         ///< of held and rigid bodies, left by the constraints
  std::array<LooseMotion, Mechanism::mostBodies> loose{};         ///< of loose ones
  std::array<ConstraintState, Mechanism::mostConstraints> laws{}; ///< the plan's, then those that were found
  FoundContacts found;                                            ///< the answer that these are of
  HandLead led;                                                   ///< by the hand, in the last tick
  Vec3 push_N = Vec3::Zero();                                     ///< on the hand, in the last tick; not spread
  Vec3 turning_N = Vec3::Zero();                                  ///< likewise, of a moment at the lever
  bool capped = false;                                            ///< the last tick did not meet the constraints
  bool placed = false;                                            ///< the held body has been somewhere
  Vec3 tip_W = Vec3::Zero();                                      ///< of the held body, as the constraints left it
  SoftEnergy soft;
  ToolBlend blend;
  WireState wire; ///< of the body in the hand
};

static_assert(std::is_trivially_destructible_v<MechanismState>);

} // namespace palpate
