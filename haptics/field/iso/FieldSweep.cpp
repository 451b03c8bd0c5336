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

/// Back from a root until rounding cannot deny that the place is free. The beginning of the way is.
Vec3 land(const TrilinearCell& cell, const Vec3& from, const Vec3& to, double root) noexcept
{
  const double margin = landingMargin(cell);
  for (double back = std::numeric_limits<double>::epsilon(), u = root; u > 0.0; u -= back, back *= 2.0)
  {
    const Vec3 t = (from + u * (to - from)).cwiseMax(0.0).cwiseMin(1.0);
    if (cell.value(t) >= margin)
    {
      return t;
    }
  }
  return from;
}

} // namespace

FieldSweepResult sweepField(const LevelSet& set, const GridPlace& from, const Vec3& way) noexcept
{
  FieldSweepResult result{ from };
  GridPlace& at = result.place;
  Vec3 left = way;
  for (;; ++result.cells)
  {
    const CellExit exit = exitOf(at.t, left);
    if (!set.field.holds(at.cell))
    {
      result.end = SweepEnd::Left;
      return result;
    }
    const TrilinearCell cell = set.cell(at.cell);
    if (!notNegative(cell))
    {
      if (!cell.valid())
      {
        result.end = SweepEnd::Left;
        return result;
      }
      if (const std::optional<double> root = crossing(cell, at.t, exit))
      {
        at.t = land(cell, at.t, exit.t, *root);
        result.end = SweepEnd::Hit;
        return result;
      }
    }
    at.t = exit.t;
    if (exit.axis < 0)
    {
      return result;
    }
    const bool up = left[exit.axis] > 0.0;
    at.cell[exit.axis] += up ? 1 : -1;
    at.t[exit.axis] = up ? 0.0 : 1.0;
    left *= 1.0 - exit.share;
  }
}

} // namespace palpate
