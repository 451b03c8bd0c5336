// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "haptics/core/Outcome.h"
#include "haptics/tool/mesh/BoxedMesh.h"
#include "haptics/tool/mesh/SimpleShape.h"

namespace palpate
{

/// A rigid tool. Its body frame B lies in the centre of mass and is turned as the mesh was given.
struct ToolMesh
{
  std::shared_ptr<const BoxedMesh> shape_B;
  Vec3 centre_W = Vec3::Zero();      ///< the centre of mass in the frame in which the mesh was given [u]
  double reach_u = 0.0;              ///< rho: no point of it is further from the centre
  double diagonal_u = 0.0;           ///< of its bounds
  double gyration_u = 0.0;           ///< radius of gyration: the usual lever between turns and ways
  std::optional<SimpleShape> simple; ///< that it is to within a fiftieth of its radius
  bool solid = false;                ///< its mass is that of a solid, else that of a sheet

  /// The radius of the ball that may be felt in its place; 0: it is none, or held elsewhere than in its middle.
  [[nodiscard]] double ball_u() const noexcept
  {
    const bool ball = this->simple && this->simple->kind == SimpleShape::Kind::Ball;
    return ball && this->simple->from_B.norm() <= this->simple->bound_u ? this->simple->radius_u : 0.0;
  }
  /// The gap at which it rests: so small that a tilted tool rests where it should to 1e-4 degrees.
  [[nodiscard]] double restGap_u() const noexcept { return 2e-7 * this->diagonal_u; }
};

/// What is felt of a tool that is a ball or a needle, and why; "": it is neither. One sentence without an end.
/// `asBall`: the ball is felt.
[[nodiscard]] std::string describeFelt(const ToolMesh& tool, bool asBall);

/// Refuses what is no finite mesh with area, has one triangle alone, more than 250,000, or parts that lie so far apart
/// that they are no one's hand tool. `handle_W`: the centre is where a hand holds it, in place of that of its mass;
/// refused far outside of the tool.
[[nodiscard]] Outcome<ToolMesh> makeTool(const TriangleMesh& raw, const std::optional<Vec3>& handle_W = std::nullopt);

/// The scene for a tool of this size, built for its rest gap. A scene that is clean, in W.
[[nodiscard]] std::shared_ptr<const BoxedMesh> makeToolScene(TriangleMesh clean, const ToolMesh& tool);

/// Why a tool cannot stand at a pose in a scene, empty when it can: numbers that are not finite, a quaternion that is
/// not of length one, coordinates so large beside the tool that its rest gap is lost in rounding.
[[nodiscard]] std::string refusePose(const ToolMesh& tool, const Pose& pose_W);
[[nodiscard]] std::string refuseScene(const ToolMesh& tool, const BoxedMesh& scene);

} // namespace palpate
