// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "haptics/compliance/mesh/TetraMesh.h"

namespace palpate
{

inline constexpr std::array<std::array<int, 2>, 6> tetraEdges{ { { 0, 1 }, { 1, 2 }, { 0, 2 }, { 0, 3 }, { 1, 3 },
  { 2, 3 } } };

/// A tetrahedron's volume [u^3] and the gradients of its barycentric coordinates [1/u].
struct TetraShape
{
  double volume_u3 = 0.0;
  std::array<Vec3, 4> gradients;
};

[[nodiscard]] inline TetraShape tetraShape(const TetraMesh& mesh, const Tetra& t)
{
  const Vec3& o = mesh.vertices_W[t[0]];
  const Vec3 a = mesh.vertices_W[t[1]] - o;
  const Vec3 b = mesh.vertices_W[t[2]] - o;
  const Vec3 c = mesh.vertices_W[t[3]] - o;
  const double six = a.cross(b).dot(c);
  TetraShape shape;
  shape.volume_u3 = six / 6.0;
  shape.gradients[1] = b.cross(c) / six;
  shape.gradients[2] = c.cross(a) / six;
  shape.gradients[3] = a.cross(b) / six;
  shape.gradients[0] = -(shape.gradients[1] + shape.gradients[2] + shape.gradients[3]);
  return shape;
}

/// Barycentric coordinates of one of the four points of equal weight that integrate a quadratic exactly.
[[nodiscard]] inline std::array<double, 4> gaussPoint(int g)
{
  constexpr double near = 0.5854101966249685; // (5 + 3 sqrt 5) / 20
  std::array<double, 4> at;
  at.fill((1.0 - near) / 3.0);
  at[g] = near;
  return at;
}

/// Gradients of the quadratic functions of four corners and six halved edges, at barycentric coordinates [1/u].
[[nodiscard]] inline std::array<Vec3, 10> quadraticGradients(const TetraShape& shape, const std::array<double, 4>& at)
{
  std::array<Vec3, 10> gradients;
  for (int a = 0; a < 4; ++a)
  {
    gradients[a] = (4.0 * at[a] - 1.0) * shape.gradients[a];
  }
  for (int e = 0; e < 6; ++e)
  {
    const auto [i, j] = tetraEdges[e];
    gradients[4 + e] = 4.0 * (at[i] * shape.gradients[j] + at[j] * shape.gradients[i]);
  }
  return gradients;
}

} // namespace palpate
