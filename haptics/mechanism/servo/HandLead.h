// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/mechanism/FoundContacts.h"
#include "haptics/mechanism/MechanismPlan.h"

namespace palpate
{

/// Where the hand was, and where that led the mesh in it: behind the hand, where the hand was faster than contacts are
/// looked for.
struct HandLead
{
  Pose hand_W;
  Pose lead_W;

  [[nodiscard]] bool isBehind() const noexcept;
};

/// Share of the reach of an answer that a pose of the mesh in the hand takes: above 1 a place may touch that was not
/// looked for. The largest motion of a corner of its bounds since then, in reaches; beside contacts, whose normals stay
/// as they are until the next answer, a turn takes reach as well. 0 where there is no answer, or no such mesh.
/// Real-time safe.
[[nodiscard]] double reachTaken(const FoundContacts& found, const PlannedBody& held, const Pose& held_W) noexcept;

/// Where the hand leads a mesh that was behind: as far behind as before, but for a share of that. Real-time safe.
[[nodiscard]] Pose followed(const HandLead& before, const Pose& hand_W, double share) noexcept;

/// How far the mesh is behind, a turn as the displacement at the end of an arm [u].
[[nodiscard]] double behind_u(const HandLead& before, double arm_u) noexcept;

/// A part of the way from one pose to another. Real-time safe.
[[nodiscard]] Pose partOfWay(const Pose& from_W, const Pose& to_W, double share) noexcept;

} // namespace palpate
