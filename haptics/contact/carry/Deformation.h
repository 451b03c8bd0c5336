// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "haptics/contact/sweep/Sweep.h"
#include "haptics/contact/view/ContactPlan.h"
#include "haptics/contact/view/GodObjectState.h"
#include "haptics/contact/view/SceneView.h"

namespace palpate
{

/// The surface of `after` that surface i of `before` has become: the same content, or the same triangles under the same
/// name with vertices elsewhere. after.size() where it is gone.
[[nodiscard]] std::uint32_t successorOf(
  const std::vector<Surface>& before, std::uint32_t i, const std::vector<Surface>& after) noexcept;

/// True if the vertices of surface `before` are elsewhere in surface `now`, which it has become.
[[nodiscard]] bool verticesMoved(const Scene& from, std::uint32_t before, const Scene& to, std::uint32_t now) noexcept;
/// The same between two moments.
[[nodiscard]] bool verticesMoved(
  const MovingScene& from, std::uint32_t before, const MovingScene& to, std::uint32_t now) noexcept;

/// First contact on a straight way in a scene, of a ball that touches nothing yet. `around`: faces that may be kept
/// around the way, or null; they change nothing but the cost.
template<SceneView AnyScene>
[[nodiscard]] SweepHit sweepStraight(const AnyScene& scene, const ContactPlan& plan, double radius_u,
  const Vec3& from_W, const Vec3& to_W, const FacesAround* around = nullptr) noexcept;

/// The place from which a point that comes straight from a free one stops short of its first contact; `to_W` where it
/// hits nothing. The way to the result is free, exactly. AnyScene: Scene or MovingScene.
template<SceneView AnyScene>
[[nodiscard]] Vec3 stopBefore(const AnyScene& scene, const ContactPlan& plan, double radius_u, const Vec3& free_W,
  const Vec3& to_W, const FacesAround* around = nullptr) noexcept;

/// Triangle of a surface that stands, in its own frame, nearest to x_W among those whose boxes are within reach_u of it
/// in each coordinate; nothing where there is none. Visits at most `budget` nodes and has the nearest of those.
[[nodiscard]] std::optional<std::uint32_t> nearestTriangle(
  const SurfaceData& surface, const Vec3& x_W, double reach_u, std::uint32_t budget) noexcept;

/// Takes the ball along with surfaces that kept their triangles while their vertices moved, so that none passes it:
/// from one scene to the next, or between two moments of vertices that are on their way.
///
/// Only where a triangle could have come over the ball on its straight way from old to new is anything done: the
/// nearest point of the old surface goes with its triangle by barycentric coordinates, and the gap between it and the
/// ball turns with the normals around it. From just above the new triangle, on the side where the ball was, the way to
/// that place is swept exactly: a surface in between stops it. A ball is moved out of surfaces that it overlaps there.
/// Beside a curve it goes with the curve's nearest point and back to where it was, as far as the curve lets it.
/// True if that took the ball through another surface, or if another surface kept it from being taken: between the two
/// there may be no room for it.
/// Bounded by plan.workBudget, allocation-free.
template<SceneView AnyScene>
[[nodiscard]] bool carryWithVertices(
  const AnyScene& from, const AnyScene& to, const ContactPlan& plan, GodObjectState& state) noexcept;

} // namespace palpate
