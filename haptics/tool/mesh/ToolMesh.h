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

/// A rigid tool. Its body frame B has its origin in the centre of mass and the axes in which the mesh was given.
struct ToolMesh
{
  std::shared_ptr<const BoxedMesh> shape_B;
  Vec3 centre_W = Vec3::Zero();      ///< the centre of mass in the frame in which the mesh was given [u]
  double reach_u = 0.0;              ///< rho: largest distance of a point from the centre
  double diagonal_u = 0.0;           ///< diagonal of its bounds
  double gyration_u = 0.0;           ///< radius of gyration: the usual lever arm between rotations and displacements
  std::optional<SimpleShape> simple; ///< its shape to within a fiftieth of its radius
  bool solid = false;                ///< its mass is that of a solid, else that of a sheet

  /// The radius of the ball that may be rendered in its place; 0: it is no ball, or is not held in its middle.
  [[nodiscard]] double ball_u() const noexcept
  {
    const bool ball = this->simple && this->simple->kind == SimpleShape::Kind::Ball;
    return ball && this->simple->from_B.norm() <= this->simple->bound_u ? this->simple->radius_u : 0.0;
  }
  /// The gap at which it rests: so small that a tilted tool rests with an error of 1e-4 degrees at most.
  [[nodiscard]] double restGap_u() const noexcept { return 2e-7 * this->diagonal_u; }
};

/// How a tool that is a ball or a needle is rendered, and why; "": it is neither. One sentence without an end.
/// `asBall`: rendered as the ball.
[[nodiscard]] std::string describeFelt(const ToolMesh& tool, bool asBall);

/// Refuses a mesh that is not finite, has no area, has one triangle alone, more than 250,000, or parts that lie so far
/// apart that it is no hand tool. `handle_W`: the centre is where a hand holds it, in place of the centre of mass;
/// refused far outside of the tool.
[[nodiscard]] Outcome<ToolMesh> makeTool(const TriangleMesh& raw, const std::optional<Vec3>& handle_W = std::nullopt);

/// The scene for a tool of this size, built for its rest gap. `clean`: in W.
[[nodiscard]] std::shared_ptr<const BoxedMesh> makeToolScene(TriangleMesh clean, const ToolMesh& tool);

/// Why a tool cannot be at a pose in a scene, empty when it can: numbers that are not finite, a quaternion that is
/// not of length one, coordinates so large beside the tool that its rest gap is lost in rounding.
[[nodiscard]] std::string refusePose(const ToolMesh& tool, const Pose& pose_W);
[[nodiscard]] std::string refuseScene(const ToolMesh& tool, const BoxedMesh& scene);

} // namespace palpate
