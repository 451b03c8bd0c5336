// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/measure/PatchAround.h"

#include <algorithm>
#include <limits>

#include "haptics/geometry/measure/SurfaceTurns.h"
#include "haptics/geometry/mesh/NearestOnTriangle.h"

namespace palpate
{
namespace
{

constexpr double farAway = std::numeric_limits<double>::infinity();

/// Of each triangle from the centre; infinite for those that no side is of.
std::vector<double> distances(const TriangleMesh& mesh, const std::vector<Side>& sides, const Vec3& centre_W)
{
  std::vector<double> found(mesh.triangles.size(), farAway);
  for (const Side& side : sides)
  {
    if (side.k == 0)
    {
      const auto& [a, b, c] = mesh.triangles[side.triangle];
      const auto& at = mesh.vertices_W;
      found[side.triangle] = (nearestOnTriangle(centre_W, at[a], at[b], at[c]) - centre_W).norm();
    }
  }
  return found;
}

} // namespace

std::vector<std::uint32_t> patchAround(const TriangleMesh& mesh, const Vec3& centre_W, double radius_u)
{
  const std::vector<Side> sides = sidesOf(mesh);
  const std::vector<double> distance_u = distances(mesh, sides, centre_W);
  const auto nearest = std::min_element(distance_u.begin(), distance_u.end());
  if (nearest == distance_u.end() || !(*nearest <= radius_u) || *nearest == farAway)
  {
    return {};
  }
  std::vector<std::vector<std::uint32_t>> beside(mesh.triangles.size());
  forEachEdge(sides,
    [&](auto first, auto last)
    {
      for (auto side = first; side != last; ++side)
      {
        for (auto other = first; other != last; ++other)
        {
          if (other->triangle != side->triangle && distance_u[other->triangle] <= radius_u)
          {
            beside[side->triangle].push_back(other->triangle);
          }
        }
      }
    });
  std::vector<bool> isIn(mesh.triangles.size());
  std::vector<std::uint32_t> patch{ static_cast<std::uint32_t>(nearest - distance_u.begin()) };
  isIn[patch.front()] = true;
  for (std::size_t i = 0; i < patch.size(); ++i)
  {
    for (const std::uint32_t next : beside[patch[i]])
    {
      if (!isIn[next])
      {
        isIn[next] = true;
        patch.push_back(next);
      }
    }
  }
  return patch;
}

} // namespace palpate
