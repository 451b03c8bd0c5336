// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>

#include "haptics/tool/mesh/BoxedMesh.h"

namespace palpate
{

/// The pose of the tool for queries of its boxes.
struct BoxPose
{
  explicit BoxPose(const Pose& pose_W) : turn(pose_W.q), turning(pose_W.q.toRotationMatrix()), centre_W(pose_W.p) {}

  [[nodiscard]] Vec3 centreOf_W(const StoredBox& tool_B) const noexcept
  {
    return this->centre_W + this->turning * tool_B.centre();
  }

  Quat turn;
  Mat3 turning; ///< the same rotation
  Vec3 centre_W;
};

/// Lower bound of the distance of two boxes.
struct BoxGap
{
  double gap_u = 0.0; ///< negative or zero: nothing is proven
  int axis = 0; ///< that shows it: 0 to 2 of the scene's box, 3 to 5 of the tool's, 6 the line between the centres
};

/// A lower bound of the distance between the contents of a box of the tool and one of the scene [u]: the best of the
/// six face normals and the line between the centres.
[[nodiscard]] BoxGap boxGap(const StoredBox& tool_B, const BoxPose& pose, const StoredBox& scene_W) noexcept;

/// A plane between two boxes, kept while the tool moves: its gap shrinks by the component of a displacement along
/// the normal, and in a rotation only in proportion to the size of the tool's box.
class BoxPlane
{
public:
  /// No plane: proves nothing.
  BoxPlane() = default;
  /// `turned_rad`: sum of the tool's rotations until now.
  BoxPlane(const BoxGap& found, const StoredBox& tool_B, const BoxPose& pose, const StoredBox& scene_W,
    double turned_rad) noexcept;

  /// A lower bound of the distance at the present pose of the tool.
  [[nodiscard]] double gap_u(const StoredBox& tool_B, const BoxPose& pose, double turned_rad) const noexcept;

private:
  std::array<float, 3> n_W_{};                              ///< from the scene to the tool, no longer than one
  double offset_u_ = std::numeric_limits<double>::lowest(); ///< gap, less the height of the centre of the tool's box
  double turned_rad_ = 0.0;
};

} // namespace palpate
