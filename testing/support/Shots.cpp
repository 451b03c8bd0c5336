// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/support/Shots.h"

#include <cmath>

#include "testing/support/Meshes.h"

namespace palpate::test
{
namespace
{

/// A point of a triangle: a vertex, a point of an edge or one of the face, each in a third of the cases.
Vec3 aim(const TriangleMesh& mesh, Random& random)
{
  const auto [a, b, c] = mesh.triangles[random.below(static_cast<std::uint32_t>(mesh.triangles.size()))];
  const double s = random.uniform(), t = random.uniform();
  switch (random.below(3))
  {
    case 0:
      return mesh.vertices_W[a];
    case 1:
      return mesh.vertices_W[a] + s * (mesh.vertices_W[b] - mesh.vertices_W[a]);
    default:
      return mesh.vertices_W[a] + s * (1 - t) * (mesh.vertices_W[b] - mesh.vertices_W[a]) +
             s * t * (mesh.vertices_W[c] - mesh.vertices_W[a]);
  }
}

} // namespace

TriangleMesh makeTarget(bool bumpy, Random& random)
{
  TriangleMesh mesh = makeSheet({ 0.06, 0.06, 24, 24, 0.35 }, random);
  for (Vec3& v : mesh.vertices_W)
  {
    v.z() = bumpy ? random.uniform(-1e-3, 1e-3) : 0.0;
  }
  return mesh;
}

Shot makeShot(const TriangleMesh& target, double clearance_m, Random& random)
{
  const Vec3 at_W = aim(target, random);
  Vec3 way = Vec3::UnitZ();
  if (random.below(3) > 0)
  {
    do
    {
      way = random.direction();
    } while (std::fabs(way.z()) < 0.35);
  }
  if (random.below(2) == 0)
  {
    way = -way;
  }
  const double before_m = random.uniform(clearance_m, 3.4e-3) / std::fabs(way.z()); // less than 9.8 mm
  return { at_W - before_m * way, at_W + random.uniform(1e-6, 10e-3 - before_m) * way };
}

} // namespace palpate::test
