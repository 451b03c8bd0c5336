// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/field/FieldBlock.h"

namespace palpate
{

/// One side of the surface f = level of the trilinear field, seen as g = side (f - level): a place is on that side if
/// the canonical value of g there, that of TrilinearCell, is not negative.
struct LevelSet
{
  FieldBlockComponent field;
  double level = 0.0;
  double side = 1.0; ///< 1 or -1

  [[nodiscard]] TrilinearCell cell(const GridIndex& at) const noexcept
  {
    return this->field.cell(at, this->level, this->side);
  }
  /// g, NaN outside the grid.
  [[nodiscard]] double value(const GridPlace& at) const noexcept
  {
    const std::optional<GridPlace> place = this->field.within(at);
    return place ? this->cell(place->cell).value(place->t) : std::nan("");
  }
};

/// How far above 0 a place has to be after a landing. Less than twenty roundings of a corner: with none, rounding at
/// the next face would block every further sweep.
[[nodiscard]] inline double landingMargin(const TrilinearCell& cell) noexcept
{
  return 7e-15 * cell.largestMagnitude();
}

} // namespace palpate
