// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "haptics/geometry/scene/Scene.h"
#include "haptics/tool/mesh/ToolMesh.h"

namespace palpate
{

/// A scene as a rigid tool touches it: the triangles of all its surfaces as one body. Curves are left out.
struct ToolSurroundings
{
  std::shared_ptr<const BoxedMesh> mesh_S;
  Pose scene_WS;       ///< where that body is: at the end of the scene's motion
  std::string refusal; ///< in words, where a tool cannot touch it
};

/// Names the body, wherever it is: another one has to be built anew.
[[nodiscard]] std::uint64_t bodyNameOf(const Scene& scene) noexcept;
/// Where it is. Surfaces that all lie in one frame move as one; those that move in ways of their own are a new body
/// with every picture, in W.
[[nodiscard]] Pose bodyPlaceOf(const Scene& scene) noexcept;

/// See noWayOut(), of the first surface that it is said of.
[[nodiscard]] std::string noWayOutOf(const Scene& scene, const ToolMesh& tool, const Pose& tool_W);

/// Refuses deforming surfaces, surfaces without triangles, and a scene that is too large for the tool. As slow as
/// building a tree is.
[[nodiscard]] ToolSurroundings surroundingsOf(const Scene& scene, const ToolMesh& tool);

} // namespace palpate
