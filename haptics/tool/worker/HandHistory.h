// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <vector>

#include "haptics/tool/worker/ToolFollower.h"

namespace palpate
{

/// The recent path of a hand that holds a tool: its poses of the last moment, each an eighth of the tool's size from
/// the next. From an older pose a tool would be drawn to the hand from further away than a person has moved it since
/// the scene changed. In another map the hand has no path.
class HandHistory
{
public:
  static constexpr double longest_s = 0.05; ///< since the hand was there

  void note(const ToolHand& hand, const ToolMesh& tool);
  /// The poses of up to longest_s before `now`; none in another map.
  [[nodiscard]] std::vector<Pose> newestFirst(const ToolHand& now) const;

private:
  struct Past
  {
    Pose pose_W;
    double left_s = 0.0; ///< when the hand was near it last
  };
  std::deque<Past> past_; ///< oldest first
  std::uint32_t map_ = 0; ///< of these poses
};

} // namespace palpate
