// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "haptics/core/Types.h"
#include "haptics/geometry/tree/SurfaceTree.h"

namespace palpate
{

/// How a surface bends at a place [1/u]: of a ball of radius r seen from outside 1/r and 1/r.
struct Curvature
{
  double largest_per_u = 0.0; ///< above 0 where the surface bulges towards `outward_W`
  double least_per_u = 0.0;

  [[nodiscard]] double mean_per_u() const noexcept { return 0.5 * (this->largest_per_u + this->least_per_u); }
  [[nodiscard]] double gaussian_per_u2() const noexcept { return this->largest_per_u * this->least_per_u; }
};

/// Curvature of a triangulated surface near a point of one of its triangles: that of the quadric that fits the vertices
/// within two rings best (Petitjean 2002), as far as they are reached without a turn of more than 60 degrees from
/// the triangle: beyond an edge another face begins. Second order in the size of the triangles. Nothing for curves and
/// where there are too few vertices to tell. Any thread.
[[nodiscard]] std::optional<Curvature> curvatureAt(
  const SurfaceTree& surface, std::uint32_t triangle, const Vec3& p_W, const Vec3& outward_W);

} // namespace palpate
