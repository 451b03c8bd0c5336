// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "haptics/geometry/tree/SurfaceTree.h"
#include "haptics/tool/mesh/ToolMesh.h"

namespace palpate
{

/// Why a tool that is free where it stands stays about there for good: a surface without holes is all around it, or it
/// is all around the surface. "": nothing of that kind. The condition and the remedy, to follow the tool's name. Asked
/// once, where the tool has just been put: from there on nothing is passed. May build a tree of the tool.
[[nodiscard]] std::string noWayOut(
  const SurfaceTree& surface, const Pose& surface_WS, const ToolMesh& tool, const Pose& tool_W);

} // namespace palpate
