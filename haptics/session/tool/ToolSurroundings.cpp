// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/tool/ToolSurroundings.h"

#include <algorithm>
#include <utility>

#include "haptics/core/PoseMath.h"
#include "haptics/session/tool/NoWayOut.h"

namespace palpate
{
namespace
{

bool isSamePlace(const Pose& a, const Pose& b) noexcept
{
  return a.p == b.p && a.q.coeffs() == b.q.coeffs();
}

bool isOneBody(const Scene& scene) noexcept
{
  const auto& surfaces = scene.surfaces();
  return std::all_of(surfaces.begin(), surfaces.end(),
    [&](const Surface& s) { return isSamePlace(s.motion.end_WS, surfaces.front().motion.end_WS); });
}

TriangleMesh trianglesOf(const Scene& scene)
{
  const bool oneBody = isOneBody(scene);
  TriangleMesh all;
  for (const Surface& surface : scene.surfaces())
  {
    if (surface.tree->coat_u() > 0.0)
    {
      continue;
    }
    const auto first = static_cast<std::ptrdiff_t>(all.vertices_W.size());
    append(all, surface.tree->mesh());
    const Pose& place = surface.motion.end_WS;
    for (auto v = all.vertices_W.begin() + (oneBody ? std::ssize(all.vertices_W) : first); v != all.vertices_W.end();
         ++v)
    {
      *v = place * *v;
    }
  }
  return all;
}

} // namespace

std::uint64_t bodyNameOf(const Scene& scene) noexcept
{
  return isOneBody(scene) ? scene.geometryHash() : scene.contentHash();
}

Pose bodyPlaceOf(const Scene& scene) noexcept
{
  return !scene.empty() && isOneBody(scene) ? scene.surfaces().front().motion.end_WS : Pose{};
}

std::string noWayOutOf(const Scene& scene, const ToolMesh& tool, const Pose& tool_W)
{
  std::string found;
  for (const Surface& surface : scene.surfaces())
  {
    found = found.empty() ? noWayOut(*surface.tree, surface.motion.end_WS, tool, tool_W) : found;
  }
  return found;
}

ToolSurroundings surroundingsOf(const Scene& scene, const ToolMesh& tool)
{
  if (scene.bends())
  {
    return { nullptr, {},
      "deforming surfaces cannot be touched with a tool: stop the animation, or use the proxy sphere" };
  }
  CleanResult clean = cleanMesh(trianglesOf(scene));
  if (!clean.ok())
  {
    return { nullptr, {}, "no visible data have triangles for a tool: show a surface" };
  }
  auto mesh = makeToolScene(std::move(clean.mesh), tool);
  std::string refusal = refuseScene(tool, *mesh);
  return { std::move(mesh), bodyPlaceOf(scene), std::move(refusal) };
}

} // namespace palpate
