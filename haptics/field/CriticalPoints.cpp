// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/field/CriticalPoints.h"

#include <algorithm>
#include <array>

#include <Eigen/LU>

namespace palpate
{
namespace
{

constexpr int mostHalvings = 4;
constexpr int mostNewton = 20;
constexpr double isRoot = 1e-12; ///< last step of Newton [cells]
constexpr double leastVolume =
  1e-4;                        ///< of the change along three directions, of that if they were square to each other
constexpr double twins = 1e-6; ///< [cells]: a place on a face is found in both cells

using VectorCell = std::array<TrilinearCell, 3>;

/// Corner values bound those of a trilinear function, so a component of one sign has no zero. One that is 0 at all
/// corners does not change.
bool mayVanish(const VectorCell& v) noexcept
{
  return std::ranges::all_of(v,
    [](const TrilinearCell& part)
    {
      const auto [low, high] = std::ranges::minmax(part.corner);
      return part.valid() && low <= 0.0 && high >= 0.0 && low < high;
    });
}

Vec3 valueAt(const VectorCell& v, const Vec3& t) noexcept
{
  return { v[0].value(t), v[1].value(t), v[2].value(t) };
}

Mat3 jacobianAt(const VectorCell& v, const Vec3& t) noexcept
{
  Mat3 jacobian;
  jacobian << v[0].gradient(t).transpose(), v[1].gradient(t).transpose(), v[2].gradient(t).transpose();
  return jacobian;
}

bool isIsolated(const Mat3& jacobian) noexcept
{
  const double square = jacobian.row(0).norm() * jacobian.row(1).norm() * jacobian.row(2).norm();
  return std::fabs(jacobian.determinant()) > leastVolume * square;
}

/// By Newton from the middle; none where that leaves the cell, or where the zero is not isolated.
std::optional<Vec3> rootIn(const VectorCell& v) noexcept
{
  Vec3 t = Vec3::Constant(0.5);
  for (int i = 0; i < mostNewton; ++i)
  {
    const Mat3 jacobian = jacobianAt(v, t);
    if (!isIsolated(jacobian))
    {
      return {};
    }
    const Vec3 step = jacobian.inverse() * valueAt(v, t);
    t -= step;
    if ((t.array() < -twins).any() || (t.array() > 1.0 + twins).any())
    {
      return {};
    }
    if (step.norm() <= isRoot)
    {
      return t;
    }
  }
  return {};
}

/// The eighth of a cell that begins at corner `which` of half its size; its values are those of the cell.
VectorCell partOf(const VectorCell& v, int which) noexcept
{
  VectorCell part;
  for (std::size_t k = 0; k < 3; ++k)
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      const Vec3 t(0.5 * ((which & 1) + (corner & 1)), 0.5 * (((which >> 1) & 1) + ((corner >> 1) & 1)),
        0.5 * (((which >> 2) & 1) + ((corner >> 2) & 1)));
      part[k].corner[static_cast<std::size_t>(corner)] = v[k].value(t);
    }
  }
  return part;
}

/// Adds the zeros of a part of a cell that begins at `begin` and is `size` of a cell long.
void lookInto(const VectorCell& v, const Vec3& begin, double size, int halvings, std::vector<Vec3>& found)
{
  if (!mayVanish(v))
  {
    return;
  }
  if (const std::optional<Vec3> t = rootIn(v))
  {
    found.push_back(begin + size * *t);
    return;
  }
  for (int which = 0; which < 8 && halvings > 0; ++which)
  {
    const Vec3 corner(which & 1, (which >> 1) & 1, (which >> 2) & 1);
    lookInto(partOf(v, which), begin + 0.5 * size * corner, 0.5 * size, halvings - 1, found);
  }
}

/// One of those that several cells have found. `found` is sorted along x.
std::vector<Vec3> withoutTwins(const std::vector<Vec3>& found)
{
  std::vector<Vec3> kept;
  for (const Vec3& place : found)
  {
    const auto isTwin = [&](const Vec3& other) { return (other - place).cwiseAbs().maxCoeff() <= 2.0 * twins; };
    const auto from = std::ranges::lower_bound(kept, place.x() - 2.0 * twins, {}, [](const Vec3& v) { return v.x(); });
    if (std::none_of(from, kept.end(), isTwin))
    {
      kept.push_back(place);
    }
  }
  return kept;
}

} // namespace

std::vector<Vec3> findCriticalPoints(const FieldBlock& brick, std::size_t most)
{
  const std::array<FieldBlockComponent, 3> parts{ brick.component(FieldBlockRole::Vector, 0),
    brick.component(FieldBlockRole::Vector, 1), brick.component(FieldBlockRole::Vector, 2) };
  const GridIndex size = parts[0].exists() ? parts[0].size() : GridIndex{};
  std::vector<Vec3> found;
  GridIndex at{};
  for (at[2] = 0; at[2] + 1 < size[2]; ++at[2])
  {
    for (at[1] = 0; at[1] + 1 < size[1]; ++at[1])
    {
      for (at[0] = 0; at[0] + 1 < size[0]; ++at[0])
      {
        lookInto({ parts[0].cell(at), parts[1].cell(at), parts[2].cell(at) }, Vec3(at[0], at[1], at[2]), 1.0,
          mostHalvings, found);
      }
    }
  }
  std::ranges::sort(found, {}, [](const Vec3& v) { return v.x(); });
  found = withoutTwins(found);
  const Vec3 middle = 0.5 * Vec3(size[0] - 1, size[1] - 1, size[2] - 1);
  std::ranges::stable_sort(found, {}, [&](const Vec3& v) { return (v - middle).squaredNorm(); });
  found.resize(std::min(found.size(), most));
  std::ranges::for_each(found, [&](Vec3& place) { place = brick.grid().toWorld(place); });
  return found;
}

} // namespace palpate
