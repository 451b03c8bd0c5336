// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/support/Facets.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace palpate::test
{
namespace
{

Vec3 unitNormal(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& t)
{
  const Vec3& a = mesh.vertices_W[t[0]];
  const Vec3 n = (mesh.vertices_W[t[1]] - a).cross(mesh.vertices_W[t[2]] - a).normalized();
  return n.dot(a) < 0 ? Vec3(-n) : n;
}

} // namespace

WorstFacets worstOf(const TriangleMesh& mesh)
{
  WorstFacets worst;
  std::map<std::pair<std::uint32_t, std::uint32_t>, Vec3> firstNormal;
  for (const auto& t : mesh.triangles)
  {
    const Vec3 n = unitNormal(mesh, t);
    const double distance = n.dot(mesh.vertices_W[t[0]]);
    if (distance < worst.faceRadius_u)
    {
      worst.faceRadius_u = distance;
      worst.faceNormal = n;
    }
    for (int k = 0; k < 3; ++k)
    {
      const std::uint32_t i = t[k], j = t[(k + 1) % 3];
      const auto [other, isNew] = firstNormal.try_emplace({ std::min(i, j), std::max(i, j) }, n);
      const double angle = isNew ? 0.0 : std::atan2(n.cross(other->second).norm(), n.dot(other->second));
      if (angle > worst.edgeAngle_rad)
      {
        worst.edgeAngle_rad = angle;
        worst.edgeMiddle = (mesh.vertices_W[i] + mesh.vertices_W[j]) / 2;
        worst.edgeAcross = (mesh.vertices_W[j] - mesh.vertices_W[i]).cross(worst.edgeMiddle).normalized();
      }
    }
  }
  return worst;
}

} // namespace palpate::test
