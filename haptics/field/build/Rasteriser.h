// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/field/FieldBlock.h"
#include "haptics/field/build/TetraBins.h"

namespace palpate
{

/// A mesh of tetrahedra with values at its points.
struct TetraField
{
  std::span<const Vec3> points_W;
  std::span<const Tetrahedron> tetrahedra;
  std::span<const float> values; ///< of the points, components together
  int components = 1;
};

/// Values of the mesh at the points of a grid, linear in each tetrahedron; NaN where there is none. Each tetrahedron
/// near the grid is scan-converted: some thousand times a point's share of a probe's cost. Inverted ones count as
/// others, those without volume do not.
[[nodiscard]] std::vector<float> rasterise(const TetraField& field, const TetraBins& bins, const FieldBlockGrid& grid);

} // namespace palpate
