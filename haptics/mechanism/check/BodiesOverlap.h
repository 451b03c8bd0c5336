// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "haptics/mechanism/check/MechanismCheck.h"
#include "haptics/mechanism/constraints/ConstraintState.h"

namespace palpate
{

/// Two bodies, by their names.
using BodyPair = std::pair<std::string, std::string>;

/// Pairs of rigid, soft and standing bodies that overlap as they stand, by their names, each pair once. Bodies that
/// only touch do not overlap; the held body has no pose yet. For surfaces: a part of an edge of one lies in the other.
/// The edges of a closed surface are taken a millionth of their length inside of it, so that coplanar faces and
/// coinciding vertices decide nothing. Not real-time safe.
[[nodiscard]] std::vector<BodyPair> overlapsOf(const Mechanism& mechanism, std::span<const MechanismSoft> soft);

/// How deep a loose and another rigid mesh lie in one another as they stand [u]: the largest distance from the surface
/// of the other one of a vertex, a little inside of its own surface, or of the mean of the vertices. 0 where only edges
/// cross. Not real-time safe.
[[nodiscard]] double overlapDepth(const Mechanism& mechanism, const BodyPair& pair);

/// In which bodies that which the hand holds lies where the hand is, at first where its frame is at W's, left out such
/// as a constraint joins it to. Of a mesh its whole surface is looked at. Not real-time safe.
[[nodiscard]] std::vector<BodyPair> overlapsOfHeld(
  const Mechanism& mechanism, std::span<const MechanismSoft> soft, const Pose& hand_W = {});

/// The first loose body that would lie in that which the hand holds, as it lies now, once all bodies are where they
/// began: put back there, it would have the hand in it, without a force. "": none. Not real-time safe.
[[nodiscard]] std::string looseInHand(const Mechanism& mechanism, const Pose& held_W);

/// Likewise in a tick: rigid bodies and the held body have the poses of the last solution, soft ones the shape of their
/// last computation. A held rod counts by its middle line, a held mesh not at all: its contacts are found. Poses
/// between two ticks are not looked at: a body thinner than the displacement of a tick can be jumped over. Bodies that
/// a constraint joins are left out: the constraint says how they meet. So are two soft bodies whose contacts are found;
/// others are looked at again once one of them was computed anew. Not real-time safe.
class OverlapWatch
{
public:
  /// `pose_W`: of each body, of those that are held or rigid; `phases`: of each constraint.
  [[nodiscard]] const std::vector<BodyPair>& look(const Mechanism& mechanism, std::span<const MechanismSoft> soft,
    std::span<const Pose> pose_W, std::span<const ConstraintPhase> phases);
  [[nodiscard]] const std::vector<BodyPair>& seen() const noexcept { return this->seen_; }

private:
  std::vector<std::uint64_t> computed_; ///< revisions of the soft bodies that these pairs are of
  std::vector<BodyPair> soft_;
  std::vector<BodyPair> seen_;
};

/// In words.
[[nodiscard]] std::string overlapText(const BodyPair& pair);

} // namespace palpate
