// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "haptics/geometry/mesh/TriangleMesh.h"

namespace palpate
{

/// Most segments of curves: as walls they take about 2 GB while they are built, and no hand tells them apart.
inline constexpr std::size_t mostSegments = 4'000'000;

/// "its lines have 5000000 segments; at most ...": one line without a name in front. Empty where they are not too many.
[[nodiscard]] std::string refuseSegments(std::size_t segments);

/// A plane world: line segments in a plane, in scene units and the coordinates of that plane.
struct CurveSet
{
  std::vector<Eigen::Vector2d> points_W;
  std::vector<std::array<std::uint32_t, 2>> segments;
};

/// Curves in a plane, or why these are none.
struct PlaneCurves
{
  CurveSet curves;
  std::string refusal; ///< one line without a name in front; empty when there are curves
};

/// The plane that segments lie in; nothing where they lie in no plane, or all on one slanted line. The plane's z is its
/// normal. The plane's x points along y of W where the plane stands across x, else along x as far as it can. The origin
/// is the point nearest to the origin of W. Curves at one height z, or one x or y, give that plane exactly.
[[nodiscard]] std::optional<Pose> planeOf(const TriangleMesh& segments);

/// Segments as they come in, (a, b, b) as segmentsOf() makes them, as curves in the plane z = 0 of plane_WP. A point is
/// in the plane if it is no further from it than single precision rounds the largest coordinate. Points that are not
/// finite are left to cleanMesh(), which counts the dropped ones. Refuses a point out of the plane, an index out of
/// range, curves without segments and more than mostSegments.
[[nodiscard]] PlaneCurves curvesInPlane(const TriangleMesh& segments, const Pose& plane_WP = {});

/// The plane world as walls: each segment becomes a rectangle from -halfHeight_u to +halfHeight_u about the plane. A
/// ball that is led in the plane meets the walls as a disc meets the lines. In the plane z = 0 of W the ball never
/// leaves the plane: the walls' normals and the feet of the contacts have no z, exactly. So one god-object serves two
/// dimensions and three. halfHeight_u > 0 must exceed the ball's radius. Indices are checked by cleanMesh().
[[nodiscard]] TriangleMesh raiseWalls(const CurveSet& curves, double halfHeight_u, const Pose& plane_WP = {});

/// The lines that walls were raised from: each wall has one triangle with two corners below the plane, on the line. The
/// points are as they were but for rounding, in the plane z = 0 of W exactly.
struct LoweredWalls
{
  CurveSet curves;
  double halfHeight_u = 0.0;
};
[[nodiscard]] LoweredWalls lowerWalls(const TriangleMesh& walls, const Pose& plane_WP = {});

/// How high walls should stand for discs up to radius_u: above the disc, and else no higher than the segments are long,
/// because taller grids are searched more slowly. A power of two, so that scaling by it rounds nothing [u].
[[nodiscard]] double wallHalfHeight(const CurveSet& curves, double radius_u);

} // namespace palpate
