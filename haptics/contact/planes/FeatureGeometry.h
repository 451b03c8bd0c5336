// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/contact/view/GodObjectState.h"
#include "haptics/contact/view/Resolution.h"
#include "haptics/contact/view/SceneView.h"
#include "haptics/core/Types.h"
#include "haptics/geometry/tree/SurfaceData.h"

namespace palpate
{

// View: SurfaceData, or PosedSurface where surfaces move. Both are instantiated in FeatureGeometry.cpp.
// r: of the ball alone; the coat of curves is added here.

/// The tangent plane of a touched feature as the ball sees it from x.
struct FeaturePlane
{
  Vec3 n = Vec3::Zero();      ///< unit, from the feature to the ball's centre
  double gap = 0.0;           ///< distance between ball and feature [u], negative when they overlap
  Vec3 foot_W = Vec3::Zero(); ///< the feature's point nearest to x
};

/// Plane of feature f of surface s for a ball of radius r at x_W. An edge is taken as its segment.
template<class View>
[[nodiscard]] FeaturePlane planeOf(const View& s, const ActiveFeature& f, const Vec3& x_W, double r) noexcept;

/// How far along the in-plane outward normal of edge k of the triangle a point lies: negative inside.
template<class View>
[[nodiscard]] double outsideOfEdge(const View& s, std::uint32_t triangle, int k, const Vec3& x_W) noexcept;

/// The same, as the outward unit normal in the triangle's plane.
template<class View>
[[nodiscard]] Vec3 outwardNormal(const View& s, std::uint32_t triangle, int k) noexcept;

/// True if the point projects into the triangle, its border included within `margin` (negative: strictly inside).
template<class View>
[[nodiscard]] bool projectsInside(const View& s, std::uint32_t triangle, const Vec3& x_W, double margin) noexcept;

/// False when f no longer touches or supports a ball of radius r at x: the feature is to be dropped.
template<class View>
[[nodiscard]] bool supports(const View& s, const ActiveFeature& f, const Vec3& x_W, double r, double tol) noexcept;

/// The feature that really holds the nearest point: a vertex becomes an edge, an edge a face, where x projects there.
template<class View>
[[nodiscard]] ActiveFeature normalised(const View& s, ActiveFeature f, const Vec3& x_W) noexcept;

/// Number of triangles examined for the successor of feature f: for a vertex its fan, else none.
template<class View>
[[nodiscard]] std::uint32_t fanOf(const View& s, const ActiveFeature& f) noexcept
{
  return f.kind == FeatureKind::Vertex ? dataOf(s).valence(f.a) : 0;
}

/// Where a motion x -> x + y along a face leaves it.
struct FaceExit
{
  double t = 1.0;             ///< fraction of y
  std::uint32_t triangle = 0; ///< the triangle reached: coplanar neighbours are walked through
  std::uint32_t i = 0, j = 0; ///< t < 1: the edge it is left by, i < j
};

/// Walks over faces that continue the starting plane; stops just outside the last one.
template<class View>
[[nodiscard]] FaceExit walkFace(
  const View& s, std::uint32_t triangle, const Vec3& x_W, const Vec3& y, double del) noexcept;

/// Fraction of y after which edge or vertex f no longer supports a ball of radius r.
template<class View>
[[nodiscard]] double exitRound(
  const View& s, const ActiveFeature& f, const Vec3& x_W, const Vec3& y, double r, double del) noexcept;

/// Face `to` with the side that is side from.side of face from.a. The two faces lie in one plane, but the order of the
/// stored corners, which gives a side its sign, differs from face to face.
template<class View>
[[nodiscard]] ActiveFeature onSamePlane(const View& s, const ActiveFeature& from, std::uint32_t to) noexcept;

/// Face `to` with the side that continues side from.side of face from.a over their common edge (i, j). The side follows
/// from how the two faces run along the edge, whatever their planes say.
template<class View>
[[nodiscard]] ActiveFeature continued(
  const View& s, const ActiveFeature& from, std::uint32_t to, std::uint32_t i, std::uint32_t j) noexcept;

/// Unit vector from vertex i to vertex j, and the length [u].
struct EdgeLine
{
  Vec3 unit = Vec3::Zero();
  double length = 0.0;
};
template<class View>
[[nodiscard]] EdgeLine edgeLine(const View& s, std::uint32_t i, std::uint32_t j) noexcept;

} // namespace palpate
