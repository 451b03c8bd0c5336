// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "haptics/contact/planes/VertexFan.h"
#include "haptics/contact/view/GodObjectState.h"
#include "haptics/contact/view/SceneView.h"

namespace palpate
{

/// Where a point at a vertex goes on along the surface.
struct Descent
{
  double gain = 0.0; ///< length of the pull that acts along the surface [u]; 0: it rests
  int count = 0;     ///< one face, or the two that meet in an edge
  std::array<ActiveFeature, 2> faces{};
  int at = 0;                            ///< index of faces[0] in the fan
  std::uint32_t far = SurfaceData::none; ///< far end of the edge, if it goes along one
};

/// The vertex at which two sides of face f meet within `margin` of x, or SurfaceData::none.
template<class View>
[[nodiscard]] std::uint32_t cornerAt(const View& s, const ActiveFeature& f, const Vec3& x_W, double margin) noexcept;

/// The steepest way along the faces of a fan, from its vertex v, for a point that is pulled by q. With `seenFrom_W` a
/// face counts only if it shows its side to that place.
template<class View>
[[nodiscard]] Descent steepestIn(
  const View& s, const VertexFan& fan, std::uint32_t v, const Vec3& q, const Vec3* seenFrom_W) noexcept;

/// The steepest way along the surface from vertex v for a point at x_W that is pulled by q and known to lie on the side
/// from which the fan is seen. Sides are carried from face to face over their common edges: near a saddle the planes
/// of the faces do not tell sides, and the sets of planes that could hold the point are not unique. Where more than two
/// faces meet in an edge, the way goes on over the next face on the point's side. Nothing is returned for a vertex of
/// more than 32 faces.
template<class View>
[[nodiscard]] std::optional<Descent> descendFromVertex(
  const View& s, const VertexFan& fan, std::uint32_t v, const Vec3& x_W, const Vec3& q) noexcept;

} // namespace palpate
