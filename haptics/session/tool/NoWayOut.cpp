// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/tool/NoWayOut.h"

#include <algorithm>

#include "haptics/core/PoseMath.h"
#include "haptics/geometry/measure/RayWalk.h"

namespace palpate
{
namespace
{

bool isAround(const SurfaceTree& closed, const Vec3& x)
{
  return isClosed(closed) && sideOf(closed, x) == PointSide::Inside;
}

/// Only a tool whose box holds all of a surface can be around it.
bool isInBoxOf(const TriangleMesh& tool_B, const SurfaceTree& surface, const Pose& surface_WS, const Pose& tool_W)
{
  Eigen::AlignedBox3d box_B;
  for (const Vec3& v : tool_B.vertices_W)
  {
    box_B.extend(v);
  }
  const auto& vertices = surface.mesh().vertices_W;
  return std::all_of(
    vertices.begin(), vertices.end(), [&](const Vec3& v) { return box_B.contains(into(tool_W, surface_WS * v)); });
}

} // namespace

std::string noWayOut(const SurfaceTree& surface, const Pose& surface_WS, const ToolMesh& tool, const Pose& tool_W)
{
  if (surface.coat_u() > 0.0)
  {
    return {}; // a tool does not touch curves
  }
  const TriangleMesh& tool_B = tool.shape_B->mesh();
  if (isAround(surface, into(surface_WS, tool_W * tool_B.vertices_W.front())))
  {
    return "is inside a closed body and cannot leave: start outside of the body";
  }
  const Vec3 onSurface_W = surface_WS * surface.mesh().vertices_W.front();
  if (isInBoxOf(tool_B, surface, surface_WS, tool_W) && isAround(SurfaceTree(tool_B), into(tool_W, onSurface_W)))
  {
    return "encloses the visible data and cannot be removed: start beside the data";
  }
  return {};
}

} // namespace palpate
