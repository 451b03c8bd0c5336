// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/tool/mesh/BoxedMesh.h"

namespace palpate
{

/// Where the tool stands, as its boxes are asked.
struct BoxPose
{
  explicit BoxPose(const Pose& pose_W) : turn(pose_W.q), turning(pose_W.q.toRotationMatrix()), centre_W(pose_W.p) {}

  Quat turn;
  Mat3 turning; ///< the same
  Vec3 centre_W;
};

/// A lower bound of the distance of what a box of the tool and one of the scene hold [u], negative or zero where
/// nothing is proven: the best of the boxes' six face normals and the line between their centres.
[[nodiscard]] double boxGap(const StoredBox& tool_B, const BoxPose& pose, const StoredBox& scene_W) noexcept;

} // namespace palpate
