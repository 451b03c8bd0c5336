// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/field/iso/FieldSweep.h"

#include "haptics/field/iso/SweepPiece.h"

namespace palpate
{

FieldSweepResult sweepField(const LevelSet& set, const GridPlace& from, const Vec3& way) noexcept
{
  FieldSweepResult result{ from };
  GridPlace& at = result.place;
  Vec3 left = way;
  SweepPiece piece, before;
  for (;; ++result.cells)
  {
    const CellExit exit = exitOf(at.t, left);
    const bool held = set.field.holds(at.cell);
    piece = held ? SweepPiece{ set.cell(at.cell), at.cell, at.t, exit.t } : SweepPiece{};
    if (!held || !notNegative(piece.cell))
    {
      if (!held || !piece.cell.valid())
      {
        at = result.cells > 0 ? GridPlace{ before.index, before.to } : from;
        result.end = SweepEnd::Left;
        return result;
      }
      if (const std::optional<double> root = crossing(piece.cell, at.t, exit))
      {
        result.met = at.cell;
        at = landBefore(from, before, piece, *root);
        result.end = SweepEnd::Hit;
        return result;
      }
    }
    at.t = exit.t;
    if (exit.axis < 0)
    {
      return result;
    }
    before = piece;
    const bool up = left[exit.axis] > 0.0;
    at.cell[exit.axis] += up ? 1 : -1;
    at.t[exit.axis] = up ? 0.0 : 1.0;
    left *= 1.0 - exit.share;
  }
}

} // namespace palpate
