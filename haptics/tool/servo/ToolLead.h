// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/core/Types.h"

namespace palpate
{

/// How the hand holds a tool: the hand's place is the tool's centre, and the tool turns as the hand turns from where
/// it was taken. So a tool begins turned as its mesh was given, keeps its turn where the device tells of none, and goes
/// on from where it was after a clutch or in another map.
struct ToolLead
{
  Quat turn_W = Quat::Identity(); ///< where the hand would have the tool
  Quat grip = Quat::Identity();   ///< from the hand's turn to the tool's
  bool taken = false;             ///< the grip is of this hand
};

/// Where the hand would have the tool. `anew`: the hand takes it as it is turned now. A turn of the hand that is none,
/// of length 0 say, leaves the tool's as it is. Real-time safe.
[[nodiscard]] Pose leadTool(const Pose& hand_W, bool anew, ToolLead& lead) noexcept;

} // namespace palpate
