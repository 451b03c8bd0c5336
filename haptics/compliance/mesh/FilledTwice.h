// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "haptics/compliance/mesh/TetraMesh.h"

namespace palpate
{

/// A straight line that begins at a place and ends after a length.
struct LinePiece
{
  Vec3 from_W = Vec3::Zero();
  Vec3 along_W = Vec3::UnitZ(); ///< unit
  double length_u = 0.0;
};

/// How much of a line lies in two tetrahedra at once, or in one that is turned inside out [u]: there a body that has
/// been bent passes through itself. `places_W`: where each vertex of the mesh has gone to. A line along an edge or a
/// face lies in all of the tetrahedra around it, so three lines a ten-thousandth of the length beside it are looked at
/// instead, and the least counts.
[[nodiscard]] double filledTwice(const TetraMesh& mesh, std::span<const Vec3> places_W, const LinePiece& line);

} // namespace palpate
