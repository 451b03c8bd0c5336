// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/mechanism/BallMesh.h"

#include <algorithm>
#include <map>

namespace palpate
{
namespace
{

constexpr int divisions = 4;

TriangleMesh octahedron()
{
  TriangleMesh mesh;
  for (const double side : { 1.0, -1.0 })
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      mesh.vertices_W.emplace_back(side * Vec3::Unit(axis));
    }
  }
  for (std::uint32_t octant = 0; octant < 8; ++octant)
  {
    const auto end = [octant](std::uint32_t axis) { return axis + (octant >> axis & 1U) * 3U; };
    const bool mirrored = ((octant ^ octant >> 1 ^ octant >> 2) & 1U) != 0;
    mesh.triangles.push_back({ end(0), end(mirrored ? 2 : 1), end(mirrored ? 1 : 2) });
  }
  return mesh;
}

TriangleMesh divided(const TriangleMesh& mesh)
{
  TriangleMesh finer;
  finer.vertices_W = mesh.vertices_W;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b)
  {
    const auto [at, isNew] =
      middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(finer.vertices_W.size()));
    if (isNew)
    {
      finer.vertices_W.push_back((mesh.vertices_W[a] + mesh.vertices_W[b]).normalized());
    }
    return at->second;
  };
  for (const auto& [a, b, c] : mesh.triangles)
  {
    const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    finer.triangles.insert(finer.triangles.end(), { { a, ab, ca }, { ab, b, bc }, { ca, bc, c }, { ab, bc, ca } });
  }
  return finer;
}

} // namespace

TriangleMesh ballMesh(double radius_u)
{
  TriangleMesh ball = octahedron();
  for (int i = 0; i < divisions; ++i)
  {
    ball = divided(ball);
  }
  for (Vec3& p : ball.vertices_W)
  {
    p *= radius_u;
  }
  return ball;
}

} // namespace palpate
