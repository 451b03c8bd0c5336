// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "haptics/realtime/TripleBuffer.h"
#include "haptics/tool/move/ToolMove.h"

namespace palpate
{

/// The hand, for the thread that moves the tool.
struct ToolHand
{
  Pose pose_W;
  bool tracked = false;  ///< false: it has not moved yet
  double friction = 0.0; ///< of each contact
  double time_s = 0.0;   ///< of its tick
  std::uint32_t map = 0; ///< another one where earlier positions are no positions of this hand
};

/// State of the thread that moves the tool, for its owner.
struct ToolReport
{
  ToolUpdate last;
  bool placed = false; ///< false: at every position of the hand the tool met the scene
  std::uint64_t updates = 0;
  std::uint64_t spent = 0; ///< updates that were out of work
};

/// The buffers between the servo, the thread that moves the tool and the owner. Each has one writer and one reader.
struct ToolLinks
{
  TripleBuffer<ToolHand> hand;         ///< servo -> follower
  TripleBuffer<ToolContacts> contacts; ///< follower -> servo
  TripleBuffer<ToolReport> report;     ///< follower -> owner
};

/// The start of a tool.
struct ToolStart
{
  Pose scene_WS;              ///< pose of the scene
  std::uint64_t revision = 0; ///< the one before the first set of contacts
  std::optional<Pose> tool_W; ///< pose of the tool if it is free there; none: no pose before
  std::vector<Pose> came_W; ///< else the recent poses of the hand, newest first: the tool begins at the first one that
                            ///< is free and goes on to the hand. If none is free, it waits for the hand
};

/// Follows the newest hand with the tool, one update per step, and publishes its contacts. A tool without a pose
/// is put where the hand is as soon as it is free there; until then there is no force. The contacts of an update that
/// ran out of work halfway would let the force drop for a tick: the last ones of a tool at rest are kept instead, for
/// a limited number of updates.
///
/// The scene may have any pose in W, as one rigid body: the tool is moved in the frame S in which its triangles are
/// given. Where the scene moves, the tool is carried along and then goes on to the hand, so that it stays on its side.
class ToolFollower
{
public:
  static constexpr std::uint64_t usualWork = 22000; ///< of an update: about 1.5 ms on a core of 2020
  /// For a tool and a scene: large ones have more triangles near one another. At most twice the usual work.
  [[nodiscard]] static std::uint64_t workOf(const ToolMesh& tool, const BoxedMesh& scene) noexcept
  {
    constexpr std::size_t trianglesPerUnit = 50;
    const std::size_t triangles = tool.shape_B->mesh().triangles.size() + scene.mesh().triangles.size();
    return usualWork + std::min<std::uint64_t>(triangles / trianglesPerUnit, usualWork);
  }
  static constexpr int longestHeld = 20; ///< updates

  /// The links must outlive it. Publishes its first contacts once the tool has a pose, so that a tool that changes to
  /// another scene is never seen between the two.
  ToolFollower(ToolMove move_S, ToolLinks& links, std::uint64_t work = usualWork, const ToolStart& start = {});

  /// The scene has this pose now, and has carried the tool along.
  void carry(const Pose& scene_WS);
  /// One update. One thread.
  void step();
  [[nodiscard]] const ToolMove& move() const noexcept { return this->move_S_; }
  [[nodiscard]] std::uint64_t revision() const noexcept { return this->revision_; }
  /// Pose of the tool; none: no pose.
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
