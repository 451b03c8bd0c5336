// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/support/SheetHeight.h"

#include <algorithm>
#include <limits>

#include "haptics/geometry/mesh/ExactPredicates.h"
#include "haptics/geometry/mesh/NearestOnTriangle.h"

namespace palpate::test
{

double distanceTo(const TriangleMesh& mesh, const Vec3& x)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& t : mesh.triangles)
  {
    const Vec3 foot = nearestOnTriangle(x, mesh.vertices_W[t[0]], mesh.vertices_W[t[1]], mesh.vertices_W[t[2]]);
    nearest = std::min(nearest, (x - foot).norm());
  }
  return nearest;
}

double heightAt(const TriangleMesh& mesh, const Vec3& x)
{
  for (const auto& t : mesh.triangles)
  {
    const Vec3 &a = mesh.vertices_W[t[0]], &b = mesh.vertices_W[t[1]], &c = mesh.vertices_W[t[2]];
    const int ab = orientation2(a.x(), a.y(), b.x(), b.y(), x.x(), x.y());
    const int bc = orientation2(b.x(), b.y(), c.x(), c.y(), x.x(), x.y());
    const int ca = orientation2(c.x(), c.y(), a.x(), a.y(), x.x(), x.y());
    if (std::min({ ab, bc, ca }) >= 0 || std::max({ ab, bc, ca }) <= 0)
    {
      const Vec3 n = (b - a).cross(c - a);
      return a.z() - (n.x() * (x.x() - a.x()) + n.y() * (x.y() - a.y())) / n.z();
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

} // namespace palpate::test
