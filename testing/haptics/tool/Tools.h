// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>

#include "CrossingJudge.h"
#include "testing/support/Meshes.h"
#include "testing/support/Random.h"

namespace palpate::test
{

constexpr double degree_rad = std::numbers::pi / 180.0;

/// Work that no update of these tests uses up.
constexpr std::uint64_t plenty = 1u << 24;

/// A tool in a scene, with the judge of all its paths.
struct JudgedTool
{
  JudgedTool(const TriangleMesh& toolMesh, const TriangleMesh& sceneMesh, int inside)
    : tool(makeTool(toolMesh).value), scene_W(makeToolScene(cleanMesh(sceneMesh).mesh, tool)),
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

inline Pose randomPose(Random& random, double range)
{
  const Vec3 p = random.inCube(range);
  return { p, turnBy(random.uniform(0.0, 3.0) * random.direction()) };
}

/// A hand that goes to random poses, each in a few updates; returns how many updates touched something.
inline std::size_t wander(JudgedTool& judged, Random& random, std::size_t updates, double range, std::uint64_t work)
{
  std::size_t touching = 0;
  Pose from = judged.move.pose_W(), to = from;
  constexpr std::size_t leg = 12;
  for (std::size_t i = 0; i < updates; ++i)
  {
    if (i % leg == 0)
    {
      from = to;
      to = randomPose(random, range);
    }
    const double share = static_cast<double>(i % leg + 1) / leg;
    const Pose hand{ from.p + share * (to.p - from.p), from.q.slerp(share, to.q) };
    judged.move.update(hand, work);
    touching += judged.move.rows().empty() ? 0 : 1;
  }
  return touching;
}

} // namespace palpate::test
