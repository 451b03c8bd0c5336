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
  Pose scene_WS;       ///< pose of that body at the end of the scene's motion
  std::string refusal; ///< why a tool cannot touch it; empty: it can
};

/// Identifies the body independently of its pose: another body has to be built anew.
[[nodiscard]] std::uint64_t bodyNameOf(const Scene& scene) noexcept;
/// Pose of the body. Surfaces that all lie in one frame move as one body; surfaces with different motions are a new
/// body with every scene, in W.
[[nodiscard]] Pose bodyPlaceOf(const Scene& scene) noexcept;

/// See noWayOut(); of the first surface to which it applies.
[[nodiscard]] std::string noWayOutOf(const Scene& scene, const ToolMesh& tool, const Pose& tool_W);

/// Refuses deforming surfaces, surfaces without triangles, and a scene that is too large for the tool. Takes as long as
/// building a tree.
[[nodiscard]] ToolSurroundings surroundingsOf(const Scene& scene, const ToolMesh& tool);

} // namespace palpate
