// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "haptics/contact/view/FaceList.h"
#include "haptics/contact/view/SceneView.h"
#include "haptics/contact/view/SweepQuery.h"

namespace palpate
{

/// First contact with one surface, whose own frame the query is given in. As sweepBall otherwise.
/// Shape: SurfaceData, or BentSurface for a moment of one whose vertices move.
template<class Shape>
[[nodiscard]] SweepHit sweepSurface(
  const Shape& shape, std::uint32_t surface, const SweepQuery& query, std::uint32_t budget) noexcept;

/// First contact of the ball with any surface of the scene.
///
/// r > 0: exact for faces, edges and vertices (Ruspini, Kolarov & Khatib 1997): a feature counts only
/// if the way gets deeper than r - tol. r = 0: the closed segment against the closed triangle in exact arithmetic;
/// a way reported free crosses and touches nothing, the order of hits is by double precision time.
/// Ties: time, then dimension (face, edge, vertex), then surface and ids. Near-first; visits at most `budget` nodes.
/// Servo thread; wait-free, no allocation.
template<SceneView AnyScene>
[[nodiscard]] SweepHit sweepBall(const AnyScene& scene, const SweepQuery& query, std::uint32_t budget) noexcept;

/// The same over a list that covers the way. Where the budget is met nothing is proven free, as a list knows no near
/// and far.
template<SceneView AnyScene>
[[nodiscard]] SweepHit sweepListed(
  const AnyScene& scene, const SweepQuery& query, const FaceList& list, std::uint32_t budget) noexcept;

/// The same over some faces: all that the way can meet.
template<SceneView AnyScene>
[[nodiscard]] SweepHit sweepFaces(
  const AnyScene& scene, const SweepQuery& query, std::span<const FaceList::Face> faces) noexcept;

/// True if the closed straight way meets face f, decided as the sweep of a point decides it.
template<SceneView AnyScene>
[[nodiscard]] bool meetsFace(const AnyScene& scene, const ActiveFeature& f, const SweepQuery& query) noexcept;

} // namespace palpate
