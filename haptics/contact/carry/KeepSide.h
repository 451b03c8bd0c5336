// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "haptics/contact/view/ContactPlan.h"
#include "haptics/contact/view/SceneView.h"
#include "haptics/core/Types.h"

namespace palpate
{

/// Where a ball belongs after a surface has given way to one that it stands for, or that stands for it; nothing where
/// it is further from it than the two may be from each other.
///
/// What is between two such surfaces is within their bound of the coarser one. So the ball is led freely, by the old
/// scene, to a place out of that: from there it comes back to x_W in the new scene and stops where the surface now is.
/// The place is looked for along the normals of the surfaces and against the pull towards p_W, on straight ways, and
/// where none of them leads out by a god-object that is drawn there; the one that is furthest from all of them is
/// taken. A pocket that winds more than that, as of a line that turns back over several of its steps, is not left.
/// `plan` is planFor()'s of the new scene. Bounded by a fixed number of sweeps, and of ticks of the god-object, for
/// each of at most four surfaces that are exchanged near the ball, each by plan.workBudget; allocation-free. AnyScene:
/// Scene or MovingScene.
template<SceneView AnyScene>
[[nodiscard]] std::optional<Vec3> keepSide(
  const AnyScene& from, const AnyScene& to, const ContactPlan& plan, const Vec3& p_W, const Vec3& x_W) noexcept;

} // namespace palpate
