// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>
#include <CGAL/squared_distance_3.h>

#include "haptics/geometry/mesh/TriangleMesh.h"

namespace palpate::test
{

/// The judges' questions to CGAL, and nothing of the code under test: yes or no exactly, lengths as doubles.
using Filtered = CGAL::Exact_predicates_inexact_constructions_kernel;
/// Lengths too.
using Rational = CGAL::Simple_cartesian<CGAL::Exact_rational>;

template<class Kernel>
[[nodiscard]] typename Kernel::Point_3 pointOf(const Vec3& v)
{
  return { v.x(), v.y(), v.z() };
}

template<class Kernel>
[[nodiscard]] typename Kernel::Segment_3 segmentOf(const Vec3& from_W, const Vec3& to_W)
{
  return { pointOf<Kernel>(from_W), pointOf<Kernel>(to_W) };
}

template<class Kernel>
[[nodiscard]] typename Kernel::Triangle_3 triangleOf(const TriangleMesh& mesh, std::uint32_t t)
{
  const auto [a, b, c] = mesh.triangles[t];
  return { pointOf<Kernel>(mesh.vertices_W[a]), pointOf<Kernel>(mesh.vertices_W[b]),
    pointOf<Kernel>(mesh.vertices_W[c]) };
}

/// Squared distance of two convex sets that do not meet: an end of one against the other, or edge against edge.
template<class Kernel>
[[nodiscard]] typename Kernel::FT squaredDistance(
  const typename Kernel::Segment_3& way, const typename Kernel::Triangle_3& triangle)
{
  auto least = std::min(CGAL::squared_distance(way.source(), triangle), CGAL::squared_distance(way.target(), triangle));
  for (int k = 0; k < 3; ++k)
  {
    const typename Kernel::Segment_3 side(triangle.vertex(k), triangle.vertex(k + 1));
    least = std::min(least, CGAL::squared_distance(way, side));
  }
  return least;
}

} // namespace palpate::test
