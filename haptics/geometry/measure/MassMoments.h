// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/geometry/mesh/TriangleMesh.h"

namespace palpate
{

/// x x^T, or its trace |x|^2.
template<class Second>
[[nodiscard]] Second secondMomentOf(const Vec3& x);
template<>
[[nodiscard]] inline Mat3 secondMomentOf(const Vec3& x)
{
  return x * x.transpose();
}
template<>
[[nodiscard]] inline double secondMomentOf(const Vec3& x)
{
  return x.squaredNorm();
}

/// Weight, first and second moments of a solid or a sheet about a point. With the point near the mesh nothing cancels
/// far from the origin. `Second`: Mat3 for the integral of x x^T, or double for its trace.
template<class Second>
struct MassMoments
{
  double weight = 0.0; ///< volume [u^3] or area [u^2]
  Vec3 first = Vec3::Zero();
  Second second = secondMomentOf<Second>(Vec3::Zero());
};

/// Adds a simplex of that weight and so many corners: a, b, c, and where it has four, the reference.
template<class Second>
void addSimplex(MassMoments<Second>& sum, double weight, double corners, const Vec3& a, const Vec3& b, const Vec3& c)
{
  const Vec3 all = a + b + c;
  sum.weight += weight;
  sum.first += weight / corners * all;
  sum.second +=
    weight / (corners * (corners + 1.0)) *
    (secondMomentOf<Second>(all) + secondMomentOf<Second>(a) + secondMomentOf<Second>(b) + secondMomentOf<Second>(c));
}

/// Adds a tetrahedron with one corner at the reference, with the sign of its volume (Mirtich 1996 has the same
/// integrals over faces).
template<class Second>
void addSolid(MassMoments<Second>& sum, const Vec3& a, const Vec3& b, const Vec3& c)
{
  addSimplex(sum, a.dot(b.cross(c)) / 6.0, 4.0, a, b, c);
}

/// Adds a triangle of uniform thickness.
template<class Second>
void addSheet(MassMoments<Second>& sum, const Vec3& a, const Vec3& b, const Vec3& c)
{
  addSimplex(sum, 0.5 * (b - a).cross(c - a).norm(), 3.0, a, b, c);
}

/// Moments of a mesh about a point, with `addSolid` or `addSheet` for each of its triangles.
template<class Second>
[[nodiscard]] MassMoments<Second> momentsOf(const TriangleMesh& mesh, const Vec3& about_W,
  void (*add)(MassMoments<Second>&, const Vec3&, const Vec3&, const Vec3&))
{
  MassMoments<Second> sum;
  for (const auto& [a, b, c] : mesh.triangles)
  {
    add(sum, mesh.vertices_W[a] - about_W, mesh.vertices_W[b] - about_W, mesh.vertices_W[c] - about_W);
  }
  return sum;
}

} // namespace palpate
