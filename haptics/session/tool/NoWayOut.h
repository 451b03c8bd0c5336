// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "haptics/geometry/tree/SurfaceTree.h"
#include "haptics/tool/mesh/ToolMesh.h"

namespace palpate
{

/// Why a tool that is free at its pose can never leave: a closed surface encloses the tool, or the tool encloses a
/// surface. "": neither. The text gives the condition and the remedy, and follows the tool's name. Called once, when
/// the tool has just been placed: afterwards nothing is passed through. May build a tree of the tool.
[[nodiscard]] std::string noWayOut(
  const SurfaceTree& surface, const Pose& surface_WS, const ToolMesh& tool, const Pose& tool_W);

} // namespace palpate
