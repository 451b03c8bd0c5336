// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "haptics/field/cells/GridPlace.h"
#include "haptics/field/cells/TrilinearCell.h"

namespace palpate
{

/// Where a sweep leaves its cell.
struct CellExit
{
  Vec3 t;
  double share = 1.0; ///< of the displacement that is left
  int axis = -1;      ///< of the face; -1: the sweep ends inside
};

/// A part of a sweep in one cell.
struct SweepPiece
{
  TrilinearCell cell;
  GridIndex index{};
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
};

[[nodiscard]] CellExit exitOf(const Vec3& t, const Vec3& way) noexcept;
[[nodiscard]] bool notNegative(const TrilinearCell& cell) noexcept;
/// The first place of a sweep in a cell that is not free. Nor is an end inside of which rounding could deny that it is.
[[nodiscard]] std::optional<double> crossing(
  const TrilinearCell& cell, const Vec3& from, const CellExit& exit) noexcept;
/// Where a sweep stops before a root of its last piece, or of the piece before where the root is just behind a face.
/// Else the sweep has not begun.
[[nodiscard]] GridPlace landBefore(
  const GridPlace& begin, const SweepPiece& before, const SweepPiece& piece, double root) noexcept;

} // namespace palpate
