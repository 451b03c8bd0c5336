// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "haptics/realtime/TripleBuffer.h"
#include "haptics/tool/move/ToolMove.h"

namespace palpate
{

/// Where the hand is, for the thread that moves the tool.
struct ToolHand
{
  Pose pose_W;
  bool tracked = false;  ///< false: nobody has moved it yet
  double friction = 0.0; ///< of each contact
  double time_s = 0.0;   ///< of the tick that this is of
  std::uint32_t map = 0; ///< another one where the places of before are no places of this hand
};

/// What an owner may read of the thread that moves the tool.
struct ToolReport
{
  ToolUpdate last;
  bool placed = false; ///< false: wherever the hand was, the tool met the scene
  std::uint64_t updates = 0;
  std::uint64_t spent = 0; ///< updates that were out of work
};

/// What the servo, the thread that moves the tool and the owner share. Each buffer has one writer and one reader.
struct ToolLinks
{
  TripleBuffer<ToolHand> hand;         ///< servo -> follower
  TripleBuffer<ToolContacts> contacts; ///< follower -> servo
  TripleBuffer<ToolReport> report;     ///< follower -> owner
};

/// Where a tool begins.
struct ToolStart
{
  Pose scene_WS;              ///< where the scene is
  std::uint64_t revision = 0; ///< the first set of contacts has the one after it
  std::optional<Pose> tool_W; ///< the tool stands there if it is free there; none: it stood nowhere
  std::vector<Pose> came_W; ///< else, newest first, where the hand came from: at the first where it is free, from where
                            ///< it goes on to the hand. Where it is free nowhere it waits for the hand
};

/// Follows the newest hand with the tool, an update a step, and hands on what it touches. A tool that stands nowhere
/// yet is put where the hand is as soon as it is free there; until then there is no force. A set that was found out of
/// work, in mid-way, would let the force drop for a tick: the last one of a tool at rest is kept instead, for so many
/// updates.
///
/// The scene may lie anywhere in W, as one rigid whole: the tool is moved in the frame S in which its triangles are
/// given. Where the scene moves, the tool goes with it and then on to the hand, so that it stays on its side.
class ToolFollower
{
public:
  static constexpr std::uint64_t usualWork = 22000; ///< of an update: about 1.5 ms on a core of 2020
  /// Of a tool and a scene: large ones are near one another with more of their triangles. At most twice the usual work.
  [[nodiscard]] static std::uint64_t workOf(const ToolMesh& tool, const BoxedMesh& scene) noexcept
  {
    constexpr std::size_t trianglesPerUnit = 50;
    const std::size_t triangles = tool.shape_B->mesh().triangles.size() + scene.mesh().triangles.size();
    return usualWork + std::min<std::uint64_t>(triangles / trianglesPerUnit, usualWork);
  }
  static constexpr int longestHeld = 20; ///< updates

  /// The links must outlive it. Hands on its first set once the tool stands, so that a tool that goes over to another
  /// scene is never seen between the two.
  ToolFollower(ToolMove move_S, ToolLinks& links, std::uint64_t work = usualWork, const ToolStart& start = {});

  /// The scene is there now, and has taken the tool along.
  void carry(const Pose& scene_WS);
  /// One update. One thread.
  void step();
  [[nodiscard]] const ToolMove& move() const noexcept { return this->move_S_; }
  [[nodiscard]] std::uint64_t revision() const noexcept { return this->revision_; }
  /// Where the tool stands; none: nowhere.
  [[nodiscard]] std::optional<Pose> tool_W() const;

private:
  [[nodiscard]] bool isPlaced(const Pose& hand_S);
  void publish();

  ToolMove move_S_;
  ToolLinks& links_;
  std::uint64_t work_;
  Pose scene_WS_;
  int held_ = 0;
  ToolReport report_;
  std::uint64_t revision_;
};

} // namespace palpate
