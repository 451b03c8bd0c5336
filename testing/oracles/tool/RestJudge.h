// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "haptics/geometry/mesh/TriangleMesh.h"
#include "testing/support/Random.h"

namespace palpate::test
{

/// Says of a tool among triangles whether it meets them, in exact arithmetic on its rounded corners, and how much
/// nearer to the hand it could still come, by a search that knows of no contacts, planes or gradients.
class RestJudge
{
public:
  /// `tool_B` about the centre that its poses are of. `characteristic_u`: lever arm [u] of turns.
  RestJudge(TriangleMesh tool_B, TriangleMesh scene_W, double characteristic_u);

  [[nodiscard]] bool meets(const Pose& pose_W) const;
  /// sqrt(displacement^2 + (lever turn)^2) from one pose to another.
  [[nodiscard]] double distance_u(const Pose& from_W, const Pose& to_W) const;
  /// By how much a chain of free random motions lowers the distance to the hand: a lower bound of the possible gain.
  [[nodiscard]] double gain_u(const Pose& pose_W, const Pose& hand_W, int trials, Random& random) const;

private:
  using Motion = Eigen::Matrix<double, 6, 1>; ///< displacement, and turn times lever
  [[nodiscard]] Motion between(const Pose& from_W, const Pose& to_W) const;
  [[nodiscard]] Pose moved(const Pose& pose_W, const Motion& motion) const;
  [[nodiscard]] bool isFree(const Pose& pose_W, const Motion& motion) const;

  TriangleMesh tool_B_, scene_W_;
  std::vector<Eigen::AlignedBox3d> sceneBoxes_;
  double characteristic_u_;
  double size_u_; ///< the diagonal of the tool's bounds
};

} // namespace palpate::test
