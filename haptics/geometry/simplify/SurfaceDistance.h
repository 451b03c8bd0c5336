// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <stop_token>

#include "haptics/geometry/tree/SurfaceData.h"
#include "haptics/geometry/tree/SurfaceTree.h"

namespace palpate
{

/// Point of a surface, and the triangle it lies on.
struct NearestPoint
{
  std::uint32_t triangle = SurfaceData::none; ///< none: nothing is as near as asked for
  Vec3 p_W = Vec3::Zero();
  double distance_u = std::numeric_limits<double>::infinity();
};

/// Nearest point of the surface to x_W, if it is not further than `within_u`. Any thread.
[[nodiscard]] NearestPoint nearestOn(
  const SurfaceData& surface, const Vec3& x_W, double within_u = std::numeric_limits<double>::infinity());

/// Whether every point of one surface has the other one near.
struct DistanceProof
{
  enum class Verdict
  {
    Within, ///< proven: no point is further than `bound_u`
    Beyond, ///< `witness_W` is further than the limit
    Open,   ///< stopped, or more pieces than was allowed
  };
  Verdict verdict = Verdict::Open;
  double bound_u = 0.0;          ///< when proven: <= the limit
  Vec3 witness_W = Vec3::Zero(); ///< a point of `from` that is further than the limit
  std::size_t pieces = 0;        ///< that were looked at
};

/// Proves that each point of `from` lies within `limit_u` of `to`: branch and bound over pieces of the triangles of
/// `from`. The distance to one triangle is convex, so a piece is within reach when its corners are within reach of the
/// same triangle; otherwise it is cut along that triangle's edges, or halved. Rounding counts against the proof.
/// One side of a Hausdorff distance (Cignoni, Rocchini & Scopigno 1998 sample it; this bounds it).
/// Any thread; O(triangles log triangles) where the surfaces are alike.
[[nodiscard]] DistanceProof proveWithin(
  const SurfaceTree& from, const SurfaceTree& to, double limit_u, std::stop_token stop = {});

} // namespace palpate
