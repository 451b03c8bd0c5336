// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/core/Types.h"

namespace palpate
{

/// The grip of a hand on a tool: the hand's position is the tool's centre, and the tool rotates as the hand rotates
/// from where it was taken. So a tool begins in the orientation of its mesh, keeps its orientation where the device
/// reports none, and goes on from its last one after a clutch or in another map.
struct ToolLead
{
  Quat turn_W = Quat::Identity(); ///< orientation that the hand gives the tool
  Quat grip = Quat::Identity();   ///< from the hand's orientation to the tool's
  bool taken = false;             ///< the grip belongs to this hand
};

/// The pose that the hand gives the tool. `anew`: the hand takes it in its present orientation. An invalid quaternion
/// of the hand, of length 0 say, leaves the tool's orientation as it is. Real-time safe.
[[nodiscard]] Pose leadTool(const Pose& hand_W, bool anew, ToolLead& lead) noexcept;

} // namespace palpate
