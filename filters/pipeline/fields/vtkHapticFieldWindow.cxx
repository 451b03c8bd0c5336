// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticFieldWindow.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

#include "haptics/field/CriticalPoints.h"
#include "haptics/field/Extrema.h"
#include "haptics/field/Smoothing.h"

using palpate::FieldBlockGrid;
using palpate::FieldBlockRole;
using palpate::GridIndex;
using palpate::Vec3;

namespace
{
constexpr double endless = std::numeric_limits<double>::infinity();

std::size_t FloatsPerPoint(const std::vector<vtkHapticFieldPart>& parts)
{
  std::size_t floats = 0;
  for (const vtkHapticFieldPart& part : parts)
  {
    floats += static_cast<std::size_t>(palpate::componentsOf(part.Role));
  }
  return floats;
}

/// Points of the lattice within a box around a place; none where the place is too far outside.
std::optional<vtkHapticFieldWindow> Around(const FieldBlockGrid& lattice, const Vec3& centre, const Vec3& reach)
{
  vtkHapticFieldWindow window;
  for (int k = 0; k < 3; ++k)
  {
    const double last = lattice.size[k] - 1;
    const double from = std::clamp(std::floor(centre[k] - reach[k]), 0.0, last);
    const double to = std::clamp(std::ceil(centre[k] + reach[k]), 0.0, last);
    if (!(to > from))
    {
      return std::nullopt;
    }
    window.First[k] = static_cast<int>(from);
    window.Size[k] = static_cast<int>(to - from) + 1;
  }
  return window;
}

std::size_t PointsOf(const vtkHapticFieldWindow& window)
{
  return static_cast<std::size_t>(window.Size[0]) * window.Size[1] * window.Size[2];
}

/// As far as asked, or as the memory of a block allows; all of it where that fits.
std::optional<vtkHapticFieldWindow> WindowAround(
  const FieldBlockGrid& lattice, const Vec3& centre_W, double reach_u, std::size_t mostPoints)
{
  if (lattice.points() <= mostPoints)
  {
    return vtkHapticFieldWindow{ {}, lattice.size };
  }
  const Vec3 centre = lattice.toIndex(centre_W);
  std::optional<vtkHapticFieldWindow> window;
  constexpr double smaller = 0.9;
  const double all_u = lattice.spacing_u.cwiseProduct(Vec3(lattice.size[0], lattice.size[1], lattice.size[2])).norm();
  const double fewCells_u = 4.0 * lattice.spacing_u.maxCoeff(); // of a hand that is small beside the cells
  for (double reach = std::min(std::max(reach_u, fewCells_u), all_u); reach > lattice.spacing_u.minCoeff();
       reach *= smaller)
  {
    window = Around(lattice, centre, reach * lattice.spacing_u.cwiseInverse());
    if (!window || PointsOf(*window) <= mostPoints)
    {
      break;
    }
  }
  return window && PointsOf(*window) <= mostPoints ? window : std::nullopt;
}

/// How far one may go from a place before a window ends that is not the end of the lattice [u].
double RoomIn(const vtkHapticFieldWindow& window, const FieldBlockGrid& lattice, const Vec3& centre_W)
{
  const Vec3 centre = lattice.toIndex(centre_W);
  double room = endless;
  for (int k = 0; k < 3; ++k)
  {
    const int last = window.First[k] + window.Size[k] - 1;
    const double below = window.First[k] > 0 ? centre[k] - window.First[k] : endless;
    const double above = last < lattice.size[k] - 1 ? last - centre[k] : endless;
    room = std::min(room, lattice.spacing_u[k] * std::min(below, above));
  }
  return std::max(0.0, room);
}

/// How far a place may go before it can be in the lattice [u]: its largest distance outside along an axis.
double WayInto(const FieldBlockGrid& lattice, const Vec3& centre_W)
{
  const Vec3 centre = lattice.toIndex(centre_W);
  double way = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    way = std::max(way, lattice.spacing_u[k] * std::max(-centre[k], centre[k] - (lattice.size[k] - 1)));
  }
  return way;
}

/// With `more` points all around, as far as there are any.
vtkHapticFieldWindow Grown(const vtkHapticFieldWindow& window, const FieldBlockGrid& lattice, int more)
{
  vtkHapticFieldWindow grown;
  for (int k = 0; k < 3; ++k)
  {
    grown.First[k] = std::max(0, window.First[k] - more);
    grown.Size[k] = std::min(lattice.size[k], window.First[k] + window.Size[k] + more) - grown.First[k];
  }
  return grown;
}

std::vector<float> Cropped(
  const std::vector<float>& values, const vtkHapticFieldWindow& grown, const vtkHapticFieldWindow& window)
{
  std::vector<float> cropped(PointsOf(window));
  for (int k = 0; k < window.Size[2]; ++k)
  {
    for (int j = 0; j < window.Size[1]; ++j)
    {
      const auto row = values.begin() + static_cast<std::ptrdiff_t>(grown.Index(window.First[0] - grown.First[0],
                                          j + window.First[1] - grown.First[1], k + window.First[2] - grown.First[2]));
      std::copy_n(row, window.Size[0], cropped.begin() + static_cast<std::ptrdiff_t>(window.Index(0, j, k)));
    }
  }
  return cropped;
}

/// Smoothing of the scalar so that no hand is trapped beside the level whose surface is felt, measured on values that
/// were read as they are.
palpate::FieldSmoothness Needed(const std::vector<float>& values, const GridIndex& size, double offset,
  const palpate::FieldBlockWish& wish, int asked)
{
  palpate::FieldSmoothness smooth;
  smooth.passes = std::max(0, asked);
  if (asked >= 0)
  {
    return smooth;
  }
  float low = std::numeric_limits<float>::infinity(), high = -low;
  for (const float value : values)
  {
    low = value < low ? value : low;
    high = value > high ? value : high;
  }
  constexpr double ofRange = 1.0 / 64; // noise beside two levels so near to each other is alike
  smooth.until = high > low ? ofRange * (static_cast<double>(high) - low) : smooth.until;
  smooth.level = wish.level;
  smooth.noise = wish.level ? palpate::measuredNoise(values, size, *wish.level - offset) : 0.0;
  smooth.passes = smooth.noise > palpate::trappingNoise ? 1 : 0;
  return smooth;
}

/// The scalar in a window, smoothed as asked or as needed, which is told.
std::vector<float> Scalar(const vtkHapticFieldPart& part, const vtkHapticFieldWindow& window,
  const FieldBlockGrid& lattice, int asked, const HapticFieldReading& read, const palpate::FieldBlockWish& wish,
  palpate::FieldSmoothness& told)
{
  const vtkHapticFieldWindow grown = Grown(window, lattice, std::abs(asked));
  std::vector<float> values = read(part, grown);
  told = Needed(values, grown.Size, part.Offset, wish, asked);
  return Cropped(palpate::smoothed(std::move(values), grown.Size, told.passes), grown, window);
}
/// Whether there is a value anywhere.
bool HasCell(const palpate::FieldBlock& brick, FieldBlockRole role)
{
  const palpate::FieldBlockComponent values = brick.component(role);
  const GridIndex& size = values.size();
  const int cells = (size[0] - 1) * (size[1] - 1) * (size[2] - 1);
  for (int i = 0; i < cells; ++i)
  {
    const int row = size[0] - 1, layer = row * (size[1] - 1);
    if (values.cell({ i % row, i % layer / row, i / layer }).valid())
    {
      return true;
    }
  }
  return false;
}

/// Critical points of the vectors, and extrema of the scalar in the remaining places.
std::vector<Vec3> SnapPlacesIn(const palpate::FieldBlock& brick)
{
  std::vector<Vec3> places_W = palpate::findCriticalPoints(brick, palpate::FieldBlock::mostPlaces / 2);
  for (const palpate::Extremum& extremum :
    palpate::findExtrema(brick, palpate::FieldBlock::mostPlaces - places_W.size()))
  {
    places_W.push_back(extremum.p_W);
  }
  return places_W;
}
} // namespace

FieldBlockGrid vtkHapticGridOf(const FieldBlockGrid& lattice, const vtkHapticFieldWindow& window)
{
  FieldBlockGrid grid = lattice;
  grid.size = window.Size;
  grid.pose_W.p = lattice.toWorld({ 1.0 * window.First[0], 1.0 * window.First[1], 1.0 * window.First[2] });
  return grid;
}

std::vector<vtkHapticFieldPart> vtkHapticFieldParts(const vtkHapticFieldArrays& arrays)
{
  std::vector<vtkHapticFieldPart> parts;
  const vtkHapticFieldPart directions =
    arrays.Tensor ? vtkHapticFieldPart{ FieldBlockRole::Axis, arrays.Vector, arrays.Eigenvector }
                  : vtkHapticFieldPart{ FieldBlockRole::Vector, arrays.Vector };
  for (const vtkHapticFieldPart& part :
    { vtkHapticFieldPart{ FieldBlockRole::Scalar, arrays.Scalar, arrays.Component, arrays.Offset }, directions,
      vtkHapticFieldPart{ FieldBlockRole::Resistance, arrays.Resistance, arrays.Component },
      vtkHapticFieldPart{ FieldBlockRole::Other, arrays.Beside ? "" : arrays.Other, arrays.Component, arrays.Offset } })
  {
    if (!part.Name.empty())
    {
      parts.push_back(part);
    }
  }
  return parts;
}

palpate::MadeFieldBlock vtkHapticFieldBlockAround(const FieldBlockGrid& lattice, const vtkHapticFieldArrays& arrays,
  const HapticFieldReading& read, const palpate::FieldBlockWish& wish, std::size_t mostBytes)
{
  const Vec3& centre_W = wish.centre_W;
  const std::vector<vtkHapticFieldPart> parts = vtkHapticFieldParts(arrays);
  const std::size_t floats = FloatsPerPoint(parts) + (arrays.Beside ? 1 : 0);
  const std::size_t mostPoints = mostBytes / (sizeof(float) * floats);
  const auto window = WindowAround(lattice, centre_W, wish.reach_u, mostPoints);
  if (!window)
  {
    return { nullptr, centre_W, WayInto(lattice, centre_W), "" }; // the hand is outside of the data
  }
  const FieldBlockGrid grid = vtkHapticGridOf(lattice, *window);
  std::vector<palpate::FieldBlockArray> values;
  palpate::FieldSmoothness smoothness;
  for (const vtkHapticFieldPart& part : parts)
  {
    const bool scalar = part.Role == FieldBlockRole::Scalar;
    values.push_back({ part.Role, part.Name,
      scalar ? Scalar(part, *window, lattice, arrays.Smoothing, read, wish, smoothness) : read(part, *window),
      part.Offset });
  }
  if (std::string problem = palpate::FieldBlock::refuse(grid, values); !problem.empty())
  {
    return { nullptr, centre_W, wish.reach_u, std::move(problem) };
  }
  auto brick = std::make_shared<const palpate::FieldBlock>(wish.revision, grid, std::move(values));
  if (std::vector<Vec3> places_W = SnapPlacesIn(*brick); !places_W.empty())
  {
    brick = std::make_shared<const palpate::FieldBlock>(wish.revision, grid, brick->arrays(), std::move(places_W));
  }
  const double room_u = RoomIn(*window, lattice, centre_W);
  if (std::isinf(room_u) && !HasCell(*brick, parts.front().Role))
  {
    return { nullptr, centre_W, room_u, "no sample has values on all sides: the data have too few visible cells" };
  }
  return { std::move(brick), centre_W, room_u, "", smoothness };
}
