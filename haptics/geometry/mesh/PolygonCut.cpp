// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/mesh/PolygonCut.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "haptics/geometry/mesh/EarCut.h"
#include "haptics/geometry/mesh/ExactPredicates.h"
#include "haptics/geometry/mesh/PlanarFill.h"

namespace palpate
{
namespace
{

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// Twice the area vector of a polygon by Newell's sum, in units of its size: neither over- nor underflows.
Vec3 areaOf(const std::vector<Vec3>& vertices_W, std::span<const std::uint32_t> corners)
{
  const Vec3& origin = vertices_W[corners[0]];
  double size = 0.0;
  for (const std::uint32_t c : corners)
  {
    size = std::max(size, (vertices_W[c] / 2 - origin / 2).cwiseAbs().maxCoeff()); // halves: the difference is finite
  }
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < corners.size() && size > 0.0; ++i)
  {
    const Vec3 a = (vertices_W[corners[i]] / 2 - origin / 2) / size;
    const Vec3 b = (vertices_W[corners[i + 1]] / 2 - origin / 2) / size;
    sum += a.cross(b);
  }
  return sum;
}

/// The polygon in the coordinate plane in which it is largest: its coordinates there are its own, without rounding.
PlanarPolygon seenAlongLargest(const std::vector<Vec3>& vertices_W, std::span<const std::uint32_t> corners)
{
  const Vec3 area = areaOf(vertices_W, corners);
  Eigen::Index axis = 0;
  area.cwiseAbs().maxCoeff(&axis);
  PlanarPolygon seen;
  seen.mirrored = area[axis] < 0.0;
  seen.points.reserve(corners.size());
  for (const std::uint32_t c : corners)
  {
    const Vec3& p_W = vertices_W[c];
    seen.points.push_back({ p_W[(axis + 1) % 3], p_W[(axis + 2) % 3], p_W[axis] });
  }
  return seen;
}

bool sameSide(int a, int b)
{
  return a * b >= 0;
}

/// The first corner of the diagonal that a quadrilateral is cut along: the shorter one of those inside; nothing where
/// it touches or crosses itself.
std::optional<std::uint32_t> diagonalOf(
  const PlanarPolygon& quad, const std::vector<Vec3>& vertices_W, std::span<const std::uint32_t> corners)
{
  const auto side = [&quad](std::size_t a, std::size_t b, std::size_t c)
  {
    const auto &p = quad.points[a], &q = quad.points[b], &r = quad.points[c];
    return orientation2(p.u, p.v, q.u, q.v, r.u, r.v);
  };
  const bool first = !sameSide(side(0, 2, 1), side(0, 2, 3)), second = !sameSide(side(1, 3, 0), side(1, 3, 2));
  const auto length = [&](std::size_t a, std::size_t b)
  { return (vertices_W[corners[b]] - vertices_W[corners[a]]).squaredNorm(); };
  if (first && second)
  {
    return length(0, 2) <= length(1, 3) ? 0u : 1u;
  }
  return first || second ? std::optional<std::uint32_t>(first ? 0u : 1u) : std::nullopt;
}

/// For each corner the first one in its place.
std::vector<std::uint32_t> placesOf(const PlanarPolygon& polygon)
{
  std::vector<std::uint32_t> order(polygon.points.size()), place(polygon.points.size());
  for (std::uint32_t i = 0; i < order.size(); ++i)
  {
    order[i] = i;
  }
  std::sort(order.begin(), order.end(),
    [&](std::uint32_t a, std::uint32_t b)
    { return polygon.points[a] != polygon.points[b] ? polygon.points[a] < polygon.points[b] : a < b; });
  for (std::size_t k = 0; k < order.size(); ++k)
  {
    const bool again = k > 0 && polygon.points[order[k]] == polygon.points[order[k - 1]];
    place[order[k]] = again ? place[order[k - 1]] : order[k];
  }
  return place;
}

bool weldsNumbers(const std::vector<std::uint32_t>& place, std::span<const std::uint32_t> corners)
{
  for (std::size_t i = 0; i < place.size(); ++i)
  {
    if (corners[place[i]] != corners[i])
    {
      return true;
    }
  }
  return false;
}

} // namespace

std::string describeHoles(const std::vector<std::size_t>& holeEdges)
{
  constexpr std::size_t mostNamed = 8;
  const std::size_t count = holeEdges.size(), named = std::min(count, mostNamed);
  std::string text = std::to_string(count) + (count == 1 ? " hole of " : " holes of ");
  for (std::size_t i = 0; i < named; ++i)
  {
    text += (i == 0 ? "" : i + 1 == count ? " and " : ", ") + std::to_string(holeEdges[i]);
  }
  return count == 0 ? "" : text + (named < count ? ", ..." : "") + " edges: polygons with a corner that is not finite";
}

PolygonCut cutPolygon(const std::vector<Vec3>& vertices_W, std::span<const std::uint32_t> corners, Triangles& triangles)
{
  const auto finite = [&](std::uint32_t c) { return vertices_W[c].allFinite(); };
  if (corners.size() <= 3) // a triangle is left to cleaning, whatever its corners are
  {
    if (corners.size() == 3)
    {
      triangles.push_back({ corners[0], corners[1], corners[2] });
    }
    return {};
  }
  if (!std::all_of(corners.begin(), corners.end(), finite))
  {
    return { corners.size(), false };
  }
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    triangles.push_back({ corners[a], corners[b], corners[c] });
  };
  PlanarPolygon polygon = seenAlongLargest(vertices_W, corners);
  if (const auto a = corners.size() == 4 ? diagonalOf(polygon, vertices_W, corners) : std::nullopt)
  {
    add(*a, *a + 1, *a + 2);
    add(*a, *a + 2, (*a + 3) % 4);
    return {};
  }
  polygon.place = placesOf(polygon);
  const bool plain = fillPlanar(polygon, add);
  if (!plain)
  {
    cutEars(polygon, add);
  }
  return { 0, plain && !weldsNumbers(polygon.place, corners) };
}

} // namespace palpate
