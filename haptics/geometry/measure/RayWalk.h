// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "haptics/core/Types.h"
#include "haptics/geometry/tree/SurfaceTree.h"

namespace palpate
{

/// Where a ray meets a surface.
struct RayHit
{
  std::uint32_t triangle = 0;
  double way_u = 0.0; ///< from where the ray begins
  Vec3 p_W = Vec3::Zero();
};

/// The first triangle of a surface of triangles that a ray meets further than `after_u` from its beginning, if there is
/// any. Whether it meets a triangle is decided exactly, for the ray's line through its beginning and a point beyond the
/// surface, so that no ray slips through an edge or a vertex; a triangle in whose plane it runs does not count.
/// `direction_W`: unit. Any thread; the tick's, too: nothing is allocated.
[[nodiscard]] std::optional<RayHit> firstHit(
  const SurfaceTree& surface, const Vec3& from_W, const Vec3& direction_W, double after_u);

/// Where a point is against a closed surface, which every ray leaves as often as it enters.
enum class PointSide : std::uint8_t
{
  Inside,
  Outside,
  On,
  Unknown, ///< every ray that was tried met an edge or a vertex
};

/// By counting the triangles that a ray passes through, each decided exactly; orientation plays no part. Meaningful
/// where `isClosed()`. Any thread.
[[nodiscard]] PointSide sideOf(const SurfaceTree& surface, const Vec3& x_W);

/// Likewise by the ray in that direction alone, in one walk over the tree; `direction_W`: unit. Nothing is allocated.
[[nodiscard]] PointSide sideOf(const SurfaceTree& surface, const Vec3& x_W, const Vec3& direction_W);

/// Whether every edge belongs to an even number of triangles, and there is one.
[[nodiscard]] bool isClosed(const SurfaceTree& surface);

} // namespace palpate
