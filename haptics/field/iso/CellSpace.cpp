// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/field/iso/CellSpace.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "haptics/field/iso/LevelSet.h"
#include "haptics/field/iso/SweepPiece.h"

namespace palpate
{
namespace
{

constexpr std::uint32_t mostSwept = 256; ///< cells of a sweep: the rest of the displacement is dropped, the next tick
                                         ///< goes on
constexpr double stands = 1e-5;          ///< of a cell's size: a segment through it that is no longer makes no progress
constexpr int mostStanding = 4;          ///< cells in turn; a segment through an edge or a vertex goes on sooner

/// Least width of a cell: between planes on which one of its coordinates is constant.
double widthOf(const Mat3& inverse) noexcept
{
  return 1.0 / std::sqrt(inverse.rowwise().squaredNorm().maxCoeff());
}

/// Second derivatives, by places in W along straight lines of local coordinates.
Mat3 alongWays(const TrilinearCell& cell, const Vec3& t, const Mat3& inverse) noexcept
{
  const Vec3 m = cell.mixed(t);
  Mat3 local;
  local << 0.0, m.z(), m.y(), m.z(), 0.0, m.x(), m.y(), m.x(), 0.0;
  return inverse.transpose() * local * inverse;
}

/// How high the corners of a cell are.
TrilinearCell heights(const CellMap& map, const Vec3& n) noexcept
{
  TrilinearCell heights;
  for (std::size_t i = 0; i < 8; ++i)
  {
    heights.corner[i] = n.dot(map.corners_W()[i] - map.corners_W()[0]);
  }
  return heights;
}

/// From a place of a cell towards another in W, in its own coordinates; ends there where the cell has it.
Vec3 localWay(const CellMap& map, const Vec3& t, const Vec3& target_W) noexcept
{
  const Vec3 way = map.jacobian(t).inverse() * (target_W - map.at(t));
  constexpr double nearly = 0.25; // a bent cell has its places elsewhere than its derivatives tell
  const Vec3 reached = t + way;
  const std::optional<Vec3> end = isInCell(reached, nearly) ? map.find(target_W, reached) : std::nullopt;
  return end && isInCell(*end, 0.0) ? Vec3(*end - t) : way;
}

} // namespace

Vec3 CellSpace::gradient_u(const TrilinearCell& cell, const GridPlace& at) const noexcept
{
  const CellMap map = this->cells_.map(at.cell);
  return map.jacobian(at.t).inverse().transpose() * cell.gradient(map.regular(at.t));
}

IsoRow CellSpace::row(const GridIndex& at, const GridPlace& x, const IsoSide& of, const Vec3& q_u) const noexcept
{
  const CellMap map = this->cells_.map(at);
  constexpr double nowhere = 9.0; // so far outside that the cell is no neighbour
  IsoRow row;
  row.cell = at;
  row.t =
    x.cell == at ? x.t : map.find(this->cells_.toWorld(x), Vec3::Constant(0.5)).value_or(Vec3(Vec3::Constant(nowhere)));
  const TrilinearCell cell = this->cell(at, of);
  const Vec3 t = map.regular(row.t);
  const Mat3 inverse = map.jacobian(t).inverse();
  const Vec3 gradient = inverse.transpose() * cell.gradient(t);
  const double slope = gradient.norm();
  row.cell_u = widthOf(inverse);
  if (!(slope * map.size_u() > flatGradient * cell.largestMagnitude() && slope < HUGE_VAL))
  {
    const double far_u = q_u.norm();
    row.n = far_u > 0.0 ? Vec3(-q_u / far_u) : Vec3(Vec3::UnitX());
    return row;
  }
  row.n = gradient / slope;
  row.gap_u = cell.value(row.t) / slope;
  row.margin_u = 2.0 * landingMargin(cell) / slope;
  row.straight = false;
  row.strays = alongWays(heights(map, row.n), t, inverse);
  row.bend = alongWays(cell, t, inverse) / slope - row.strays; // less the part of the bent coordinates themselves
  return row;
}

double CellSpace::least_u(const GridPlace& at) const noexcept
{
  return widthOf(this->cells_.map(at.cell).jacobian(at.t).inverse());
}

std::optional<GridPlace> CellSpace::ahead(
  const GridPlace& at, const Vec3& left_u, double step_u, int other) const noexcept
{
  const double far_u = left_u.norm();
  return far_u > 0.0 ? this->cells_.locate(this->cells_.toWorld(at) + (step_u / far_u) * left_u, other) : std::nullopt;
}

std::optional<GridPlace> CellSpace::beyond(const GridPlace& at, int face, const Vec3& left_u) const noexcept
{
  if (std::optional<GridPlace> next = this->cells_.across(at, face))
  {
    return next;
  }
  // Cells that touch without sharing the corners of a face, such as those on both sides of a seam.
  constexpr double share = 1e-6; // of the cell's least width: further than rounding, and nothing that is felt
  return this->ahead(at, left_u, share * this->least_u(at), at.cell[0]);
}

std::optional<GridPlace> CellSpace::offEdge(const GridPlace& at, const Vec3& left_u) const noexcept
{
  constexpr double share = 1e-4; // of the cell: further than derivatives beside coinciding corners are off
  const double step_u = std::min(share * this->cells_.map(at.cell).size_u(), left_u.norm());
  const Vec3 aside_u = left_u.cross(Vec3(0.36, 0.48, 0.8)); // so that the rest of the displacement is not along that
                                                            // edge
  const std::optional<GridPlace> one = this->ahead(at, left_u + aside_u, step_u, -1);
  return one ? one : this->ahead(at, left_u - aside_u, step_u, -1);
}

FieldSweepResult CellSpace::sweep(const IsoSide& of, const GridPlace& from, const Vec3& way_u) const noexcept
{
  const Vec3 target_W = this->cells_.toWorld(from) + way_u;
  FieldSweepResult result{ from };
  GridPlace& at = result.place;
  SweepPiece before;
  int standing = 0;
  for (; result.cells < mostSwept; ++result.cells)
  {
    const CellMap map = this->cells_.map(at.cell);
    const Vec3 way = localWay(map, at.t, target_W);
    if (!way.allFinite())
    {
      return result;
    }
    const CellExit exit = exitOf(at.t, way);
    const SweepPiece piece{ this->cell(at.cell, of), at.cell, at.t, exit.t };
    const std::optional<double> root = notNegative(piece.cell) ? std::nullopt : crossing(piece.cell, at.t, exit);
    if (root)
    {
      result.met = at.cell;
      at = landBefore(from, before, piece, *root);
      result.end = SweepEnd::Hit;
      return result;
    }
    const bool stood = (map.at(exit.t) - map.at(at.t)).norm() <= stands * map.size_u();
    standing = stood ? standing + 1 : 0;
    at.t = exit.t;
    if (exit.axis < 0)
    {
      return result;
    }
    const int face = 2 * exit.axis + (way[exit.axis] > 0.0 ? 1 : 0);
    const Vec3 left_u = target_W - map.at(at.t);
    const bool around = standing >= mostStanding; // from cell to cell about an edge that the sweep goes along
    const std::optional<GridPlace> next = around ? this->offEdge(at, left_u) : this->beyond(at, face, left_u);
    standing = around ? 0 : standing;
    if (!next)
    {
      result.end = SweepEnd::Left;
      return result;
    }
    if (this->cell(next->cell, of).value(next->t) < 0.0)
    {
      result.met = next->cell; // cells that touch without sharing a face may differ there
      result.end = SweepEnd::Hit;
      return result;
    }
    before = stood ? before : piece; // on one that makes no progress there is nowhere to land
    at = *next;
  }
  return result;
}

} // namespace palpate
