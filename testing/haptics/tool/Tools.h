// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>

#include "CrossingJudge.h"
#include "testing/support/Meshes.h"

namespace palpate::test
{

constexpr double degree_rad = std::numbers::pi / 180.0;

/// Work that no update of these tests uses up.
constexpr std::uint64_t plenty = 1u << 24;

/// A tool in a scene, with the judge of all its ways.
struct JudgedTool
{
  JudgedTool(const TriangleMesh& toolMesh, const TriangleMesh& sceneMesh, int inside)
    : tool(makeTool(toolMesh).tool), scene_W(makeToolScene(cleanMesh(sceneMesh).mesh, tool)),
      move(tool, scene_W, tool.gyration_u), judge(*tool.shape_B, *scene_W, inside)
  {
    move.watch(&judge);
  }

  ToolMesh tool;
  std::shared_ptr<const BoxedMesh> scene_W;
  ToolMove move;
  CrossingJudge judge;
};

/// Moves until nothing moves any more; false if it did not come to rest in so many updates.
inline bool settle(ToolMove& move, const Pose& device_W, int updates = 40)
{
  for (int i = 0; i < updates; ++i)
  {
    if (move.update(device_W, plenty).converged)
    {
      return true;
    }
  }
  return false;
}

} // namespace palpate::test
