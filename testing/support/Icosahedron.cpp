// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/support/Icosahedron.h"

#include <cmath>

namespace palpate::test
{

TriangleMesh icosahedron()
{
  const double t = (1 + std::sqrt(5.0)) / 2; // golden ratio
  TriangleMesh mesh;
  mesh.vertices_W = { { -1, t, 0 }, { 1, t, 0 }, { -1, -t, 0 }, { 1, -t, 0 }, { 0, -1, t }, { 0, 1, t }, { 0, -1, -t },
    { 0, 1, -t }, { t, 0, -1 }, { t, 0, 1 }, { -t, 0, -1 }, { -t, 0, 1 } };
  for (Vec3& v : mesh.vertices_W)
  {
    v.normalize();
  }
  mesh.triangles = { { 0, 11, 5 }, { 0, 5, 1 }, { 0, 1, 7 }, { 0, 7, 10 }, { 0, 10, 11 }, { 1, 5, 9 }, { 5, 11, 4 },
    { 11, 10, 2 }, { 10, 7, 6 }, { 7, 1, 8 }, { 3, 9, 4 }, { 3, 4, 2 }, { 3, 2, 6 }, { 3, 6, 8 }, { 3, 8, 9 },
    { 4, 9, 5 }, { 2, 4, 11 }, { 6, 2, 10 }, { 8, 6, 7 }, { 9, 8, 1 } };
  return mesh;
}

} // namespace palpate::test
