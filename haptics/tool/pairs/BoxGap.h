// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>

#include "haptics/tool/mesh/BoxedMesh.h"

namespace palpate
{

/// Where the tool stands, as its boxes are asked.
struct BoxPose
{
  explicit BoxPose(const Pose& pose_W) : turn(pose_W.q), turning(pose_W.q.toRotationMatrix()), centre_W(pose_W.p) {}

  [[nodiscard]] Vec3 centreOf_W(const StoredBox& tool_B) const noexcept
  {
    return this->centre_W + this->turning * tool_B.centre();
  }

  Quat turn;
  Mat3 turning; ///< the same
  Vec3 centre_W;
};

/// How far two boxes are apart, at the least.
struct BoxGap
{
  double gap_u = 0.0; ///< negative or zero where nothing is proven
  int axis = 0; ///< that shows it: of the scene's box 0 to 2, of the tool's 3 to 5, the line between the centres 6
};

/// A lower bound of the distance of what a box of the tool and one of the scene hold [u]: the best of the boxes' six
/// face normals and the line between their centres.
[[nodiscard]] BoxGap boxGap(const StoredBox& tool_B, const BoxPose& pose, const StoredBox& scene_W) noexcept;

/// A plane between two boxes, kept while the tool moves: of a motion it loses only so much as goes along its normal,
/// and of a turn only so much as the tool's box is large.
class BoxPlane
{
public:
  /// Shows nothing.
  BoxPlane() = default;
  /// `turned_rad`: sum of the tool's turns until now.
  BoxPlane(const BoxGap& found, const StoredBox& tool_B, const BoxPose& pose, const StoredBox& scene_W,
    double turned_rad) noexcept;

  /// A lower bound of the distance where the tool stands now.
  [[nodiscard]] double gap_u(const StoredBox& tool_B, const BoxPose& pose, double turned_rad) const noexcept;

private:
  std::array<float, 3> n_W_{};                              ///< from the scene to the tool, no longer than one
  double offset_u_ = std::numeric_limits<double>::lowest(); ///< gap, less the height of the centre of the tool's box
  double turned_rad_ = 0.0;
};

} // namespace palpate
