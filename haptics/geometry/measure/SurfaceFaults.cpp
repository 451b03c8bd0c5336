// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/measure/SurfaceFaults.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "haptics/core/DisjointSets.h"
#include "haptics/geometry/measure/RayWalk.h"
#include "haptics/geometry/measure/SurfaceTurns.h"
#include "haptics/geometry/measure/WallThickness.h"

namespace palpate
{
namespace
{

std::vector<SurfaceHole> holesOf(const TriangleMesh& mesh, const std::vector<Side>& sides)
{
  std::vector<Side> rim;
  DisjointSets groups(mesh.vertices_W.size());
  forEachEdge(sides,
    [&](auto first, auto last)
    {
      if (last - first == 1)
      {
        rim.push_back(*first);
        groups.join(first->low, first->high);
      }
    });
  std::map<std::uint32_t, SurfaceHole> byGroup;
  for (const Side& side : rim)
  {
    SurfaceHole& hole = byGroup[groups.of(side.low)];
    const double length_u = (mesh.vertices_W[side.high] - mesh.vertices_W[side.low]).norm();
    hole.centre_W += 0.5 * length_u * (mesh.vertices_W[side.low] + mesh.vertices_W[side.high]);
    hole.length_u += length_u;
    hole.vertices.insert(hole.vertices.end(), { side.low, side.high });
    hole.edges.push_back({ side.low, side.high });
  }
  std::vector<SurfaceHole> holes;
  for (auto& [group, hole] : byGroup)
  {
    hole.centre_W /= hole.length_u;
    std::sort(hole.vertices.begin(), hole.vertices.end());
    hole.vertices.erase(std::unique(hole.vertices.begin(), hole.vertices.end()), hole.vertices.end());
    holes.push_back(std::move(hole));
  }
  std::sort(holes.begin(), holes.end(), [](const auto& a, const auto& b) { return a.length_u > b.length_u; });
  return holes;
}

/// All but one part, to find the parts that enclose it.
std::optional<SurfaceTree> othersThan(const TriangleMesh& mesh, const Turns& turns, std::uint32_t part)
{
  TriangleMesh others{ mesh.vertices_W, {} };
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (turns.part[t] != part && turns.part[t] != Turns::none)
    {
      others.triangles.push_back(mesh.triangles[t]);
    }
  }
  CleanResult clean = cleanMesh(others);
  return clean.ok() ? std::optional<SurfaceTree>(std::in_place, std::move(clean.mesh)) : std::nullopt;
}

/// Whether the first triangle of a part is turned as it should be: outwards, or inwards in a hollow, or as most of a
/// part with a rim.
bool isFirstRight(const TriangleMesh& mesh, const Turns& turns, std::uint32_t part, bool closed)
{
  const auto& members = turns.members[part];
  const auto alike = static_cast<std::size_t>(
    std::count_if(members.begin(), members.end(), [&](std::uint32_t t) { return turns.asFirst[t]; }));
  if (!closed)
  {
    return 2 * alike >= members.size();
  }
  const bool outwards = sixVolumesOf(mesh, turns, part) > 0.0;
  if (turns.members.size() == 1)
  {
    return outwards;
  }
  const std::optional<SurfaceTree> others = othersThan(mesh, turns, part);
  const Vec3& place_W = mesh.vertices_W[mesh.triangles[members.front()][0]];
  const bool hollow = others && sideOf(*others, place_W) == PointSide::Inside;
  return outwards != hollow;
}

std::vector<bool> closedParts(const Turns& turns, const std::vector<Side>& sides)
{
  std::vector<bool> closed(turns.members.size(), true);
  forEachEdge(sides,
    [&](auto first, auto last)
    {
      if (last - first != 2)
      {
        std::for_each(first, last, [&](const Side& side) { closed[turns.part[side.triangle]] = false; });
      }
    });
  return closed;
}

/// Whether each triangle is turned as it should be.
std::vector<bool> rightTurns(const TriangleMesh& mesh, const Turns& turns, const std::vector<Side>& sides)
{
  const std::vector<bool> closed = closedParts(turns, sides);
  std::vector<bool> right(mesh.triangles.size(), true);
  for (std::uint32_t part = 0; part < turns.members.size(); ++part)
  {
    const bool first = isFirstRight(mesh, turns, part, closed[part]);
    for (const std::uint32_t t : turns.members[part])
    {
      right[t] = turns.asFirst[t] == first;
    }
  }
  return right;
}

/// Flipped triangles that share an edge are one part.
std::vector<FlippedPart> flippedOf(
  const TriangleMesh& mesh, const std::vector<Side>& sides, const std::vector<bool>& right)
{
  DisjointSets groups(mesh.triangles.size());
  forEachEdge(sides,
    [&](auto first, auto last)
    {
      if (last - first == 2 && !right[first->triangle] && !right[(first + 1)->triangle])
      {
        groups.join(first->triangle, (first + 1)->triangle);
      }
    });
  std::map<std::uint32_t, FlippedPart> byGroup;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (!right[t])
    {
      byGroup[groups.of(t)].triangles.push_back(t);
    }
  }
  std::vector<FlippedPart> parts;
  for (auto& [group, part] : byGroup)
  {
    parts.push_back(std::move(part));
  }
  std::stable_sort(
    parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.triangles.size() > b.triangles.size(); });
  return parts;
}

std::vector<ThinPlace> thinOf(
  const TriangleMesh& mesh, const Turns& turns, const std::vector<bool>& right, double thin_u)
{
  CleanResult clean = cleanMesh(mesh);
  if (!clean.ok())
  {
    return {};
  }
  const SurfaceTree tree(std::move(clean.mesh));
  std::vector<ThinPlace> thin;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (turns.part[t] == Turns::none)
    {
      continue;
    }
    const auto& [i, j, k] = mesh.triangles[t];
    const Vec3 &a = mesh.vertices_W[i], &b = mesh.vertices_W[j], &c = mesh.vertices_W[k];
    const Vec3 inward_W = (right[t] ? -1.0 : 1.0) * (b - a).cross(c - a).normalized();
    const auto thickness_u = wallThickness_u(tree, (a + b + c) / 3.0, inward_W);
    if (thickness_u && *thickness_u < thin_u)
    {
      thin.push_back({ t, *thickness_u });
    }
  }
  std::stable_sort(
    thin.begin(), thin.end(), [](const auto& a, const auto& b) { return a.thickness_u < b.thickness_u; });
  return thin;
}

} // namespace

SurfaceFaults findFaults(const TriangleMesh& mesh, double thin_u)
{
  const std::vector<Side> sides = sidesOf(mesh);
  const Turns turns(mesh, sides);
  const std::vector<bool> right = rightTurns(mesh, turns, sides);
  SurfaceFaults faults;
  faults.holes = holesOf(mesh, sides);
  faults.flipped = flippedOf(mesh, sides, right);
  if (thin_u > 0.0 && faults.holes.empty())
  {
    faults.thin = thinOf(mesh, turns, right, thin_u);
  }
  return faults;
}

} // namespace palpate
