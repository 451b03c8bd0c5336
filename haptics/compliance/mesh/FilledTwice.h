// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "haptics/compliance/mesh/TetraMesh.h"

namespace palpate
{

/// A straight line that begins at a point and ends after a length.
struct LinePiece
{
  Vec3 from_W = Vec3::Zero();
  Vec3 along_W = Vec3::UnitZ(); ///< unit
  double length_u = 0.0;
};

/// Length of a line that lies in two tetrahedra at once, or in an inverted one [u]: there a body that has
/// been bent passes through itself. `places_W`: the present position of each vertex. A line along an edge or a
/// face lies in all of the tetrahedra around it, so three lines a ten-thousandth of the length beside it are examined
/// instead, and the least counts.
[[nodiscard]] double filledTwice(const TetraMesh& mesh, std::span<const Vec3> places_W, const LinePiece& line);

} // namespace palpate
