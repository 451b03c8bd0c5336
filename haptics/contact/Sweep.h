// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "haptics/contact/GodObject.h"
#include "haptics/contact/Resolution.h"
#include "haptics/core/Types.h"
#include "haptics/geometry/Scene.h"

namespace palpate
{

struct SurfaceData;
class Neighbourhood;

/// A ball of radius r on its way from x to e.
struct SweepQuery
{
  Vec3 from_W = Vec3::Zero();
  Vec3 to_W = Vec3::Zero();
  double radius_u = 0.0;
  Resolution resolution;
  std::span<const ActiveFeature> touched; ///< not hit again: their planes already hold the ball
};

/// A straight way with nothing touched, resolved as its ends are.
[[nodiscard]] inline SweepQuery straightQuery(const Vec3& from_W, const Vec3& to_W, double radius_u = 0.0) noexcept
{
  SweepQuery query{ from_W, to_W, radius_u, {}, {} };
  query.resolution.include(from_W);
  query.resolution.include(to_W);
  return query;
}

/// The first contact, if any.
struct SweepHit
{
  bool hit = false;
  double t = 1.0; ///< fraction of the way, in [0, 1]
  ActiveFeature feature;
  double freeUntil = 1.0; ///< below 1 only when the budget was met: proven free up to here
  std::uint32_t work = 0; ///< done, in the unit of ContactPlan::workBudget
};

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
/// `near`, if given, keeps the faces around from one sweep to the next; it changes the cost and nothing else.
/// SceneView: Scene, or MovingScene for a moment of one that moves.
template<class SceneView>
[[nodiscard]] SweepHit sweepBall(
  const SceneView& scene, const SweepQuery& query, std::uint32_t budget, Neighbourhood* near = nullptr) noexcept;

/// True if the closed straight way meets face f, decided as the sweep of a point decides it.
template<class SceneView>
[[nodiscard]] bool meetsFace(const SceneView& scene, const ActiveFeature& f, const SweepQuery& query) noexcept;

} // namespace palpate
