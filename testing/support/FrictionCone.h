// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "testing/support/TriangleGrid.h"

namespace palpate::test
{

/// Unit normals of the features that a ball touches, from the surface to its centre, equal ones once. Of a point: of
/// the faces it is as near to as `reach_u`, on its side of each in exact arithmetic. Of a ball: from the nearest point
/// of each triangle that is no further than its radius and `reach_u`.
[[nodiscard]] std::vector<Vec3> touchedNormals(
  const TriangleGrid& grid, const Vec3& centre_W, double radius_u, double reach_u);

/// True if any triangle is as near as `reach_u`.
[[nodiscard]] bool touches(const TriangleGrid& grid, const Vec3& centre_W, double reach_u);

/// How far outside its friction cone a god-object is drawn: the device's place from the god-object is
/// -sum l_i n_i + t with l_i >= 0 for up to three of the normals and t in all their planes; this is the least
/// |t| - mu sum l_i of all choices of normals, [u], 0 if there is a choice for which it is below 0.
/// `pull_W`: from the god-object to the device. Infinite if there is nothing to draw against.
[[nodiscard]] double beyondFriction(std::span<const Vec3> normals, const Vec3& pull_W, double mu);

} // namespace palpate::test
