// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/lab/methods/Planes.h"

#include <cmath>

#include "haptics/contact/planes/Projection.h"

namespace palpate::lab
{

Plane planeTowards(const Face& face, const Vec3& from_W, double gap)
{
  const Vec3 n = face.normal_W.dot(from_W - face.point_W) < 0 ? Vec3(-face.normal_W) : face.normal_W;
  return { n, n.dot(face.point_W) + gap };
}

bool same(const Plane& a, const Plane& b, double tolerance)
{
  return a.n.dot(b.n) > 1 - 1e-12 && std::abs(a.c - b.c) < tolerance;
}

Vec3 nearestInFront(const std::vector<Plane>& planes, const Vec3& p_W)
{
  std::vector<PlaneRow> rows;
  for (const Plane& plane : planes)
  {
    rows.push_back({ plane.n, -plane.height(p_W) });
  }
  const ProjectionResult result = projectOntoPlanes(rows, Vec3::Zero(), 1e-15);
  return p_W + result.y;
}

} // namespace palpate::lab
