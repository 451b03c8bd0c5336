// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "haptics/compliance/map/SurfaceMap.h"

namespace palpate
{

/// The share of a frame's motion in that of a point.
struct FrameWeight
{
  std::uint32_t frame = 0;
  double weight = 0.0;
};

/// A map of points that follow rigid frames: u = sum of w (t + turn x (p - origin)). Each frame counts as two nodes,
/// number 2 i for its displacement and 2 i + 1 for its rotation [rad]; forces come back as its force and its moment.
/// One frame with weight 1 is a rigid body; weights of several that add up to 1 are skinning. For small rotations;
/// after a large one the frame is to be given anew.
[[nodiscard]] SurfaceMap followFrames(const std::vector<Vec3>& origins_W, const std::vector<Vec3>& points_W,
  const std::vector<std::vector<FrameWeight>>& weights);

/// A map of points that are some of the nodes themselves.
[[nodiscard]] SurfaceMap followNodes(const std::vector<std::uint32_t>& nodes);

} // namespace palpate
