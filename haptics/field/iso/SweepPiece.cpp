// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/field/iso/SweepPiece.h"

#include <algorithm>
#include <limits>

#include "haptics/field/iso/Crossing.h"
#include "haptics/field/iso/LevelSet.h"

namespace palpate
{
namespace
{

/// Back from a root until rounding cannot deny that the place is free. None: that is nowhere in this piece.
std::optional<GridPlace> landed(const SweepPiece& piece, double root) noexcept
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

} // namespace

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

std::optional<double> crossing(const TrilinearCell& cell, const Vec3& from, const CellExit& exit) noexcept
{
  const WayCubic cubic(cell, from, exit.t);
  const std::optional<double> root = cubic.free() ? std::nullopt : cubic.firstCrossing();
  const bool endsTooNear = exit.axis < 0 && cubic.b[3] < landingMargin(cell);
  return root || !endsTooNear ? root : 1.0;
}

GridPlace landBefore(const GridPlace& begin, const SweepPiece& before, const SweepPiece& piece, double root) noexcept
{
  std::optional<GridPlace> place = landed(piece, root);
  if (!place && before.from != before.to)
  {
    place = landed(before, 1.0);
  }
  return place.value_or(begin);
}

} // namespace palpate
