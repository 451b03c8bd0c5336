// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "haptics/tool/worker/ToolFollower.h"

namespace palpate
{

/// Where a hand that holds a tool came from: the last poses, each an eighth of the tool's size from the next. By way
/// and not by time, so that a hand that rests forgets nothing.
class HandHistory
{
public:
  static constexpr std::size_t capacity = 64; ///< the way of eight sizes

  void note(const ToolHand& hand, const ToolMesh& tool);
  [[nodiscard]] std::vector<Pose> newestFirst() const;

private:
  std::vector<Pose> poses_W_; ///< once it is full, a ring
  std::size_t next_ = 0;
};

} // namespace palpate
