// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/field/iso/FieldSweep.h"

#include <algorithm>
#include <limits>

#include "haptics/field/iso/Crossing.h"

namespace palpate
{
namespace
{

/// Where a way leaves its cell.
struct CellExit
{
  Vec3 t;
  double share = 1.0; ///< of the way that is left
  int axis = -1;      ///< of the face; -1: the way ends inside
};

CellExit exitOf(const Vec3& t, const Vec3& way) noexcept
{
  CellExit exit;
  for (int k = 0; k < 3; ++k)
  {
    if (way[k] != 0.0)
    {
      const double share = ((way[k] > 0.0 ? 1.0 : 0.0) - t[k]) / way[k];
      if (share < exit.share)
      {
        exit.share = share;
        exit.axis = k;
      }
    }
  }
  exit.t = (t + exit.share * way).cwiseMax(0.0).cwiseMin(1.0);
  if (exit.axis >= 0)
  {
    exit.t[exit.axis] = way[exit.axis] > 0.0 ? 1.0 : 0.0; // exactly: the next cell has the same value there
  }
  return exit;
}

bool notNegative(const TrilinearCell& cell) noexcept
{
  return std::ranges::all_of(cell.corner, [](double value) { return value >= 0.0; });
}

/// The first place of a way in a cell that is not free. Nor is an end inside of which rounding could deny that it is.
std::optional<double> crossing(const TrilinearCell& cell, const Vec3& from, const CellExit& exit) noexcept
{
  const WayCubic cubic(cell, from, exit.t);
  const std::optional<double> root = cubic.free() ? std::nullopt : cubic.firstCrossing();
  const bool endsTooNear = exit.axis < 0 && cubic.b[3] < landingMargin(cell);
  return root || !endsTooNear ? root : 1.0;
}

/// A part of a way in one cell.
struct Piece
{
  TrilinearCell cell;
  GridIndex index{};
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
};

/// Back from a root until rounding cannot deny that the place is free. None: that is nowhere in this piece.
std::optional<GridPlace> landed(const Piece& piece, double root) noexcept
{
  const double margin = landingMargin(piece.cell);
  for (double back = std::numeric_limits<double>::epsilon(), u = root; u > 0.0; u -= back, back *= 2.0)
  {
    const Vec3 t = (piece.from + u * (piece.to - piece.from)).cwiseMax(0.0).cwiseMin(1.0);
    if (piece.cell.value(t) >= margin)
    {
      return GridPlace{ piece.index, t };
    }
  }
  return {};
}

/// Before a root that is just behind a face, the piece before may have the landing. Else the way has not begun.
GridPlace land(const GridPlace& begin, const Piece& before, const Piece& piece, double root) noexcept
{
  std::optional<GridPlace> place = landed(piece, root);
  if (!place && before.from != before.to)
  {
    place = landed(before, 1.0);
  }
  return place.value_or(begin);
}

} // namespace

FieldSweepResult sweepField(const LevelSet& set, const GridPlace& from, const Vec3& way) noexcept
{
  FieldSweepResult result{ from };
  GridPlace& at = result.place;
  Vec3 left = way;
  Piece piece, before;
  for (;; ++result.cells)
  {
    const CellExit exit = exitOf(at.t, left);
    const bool held = set.field.holds(at.cell);
    piece = held ? Piece{ set.cell(at.cell), at.cell, at.t, exit.t } : Piece{};
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
        at = land(from, before, piece, *root);
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
