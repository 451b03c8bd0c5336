// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "haptics/contact/view/ContactPlan.h"
#include "haptics/contact/view/SceneView.h"
#include "haptics/core/Types.h"

namespace palpate
{

/// Where a ball belongs after a surface has been exchanged for a simpler one that stands for it, or a simpler one for
/// the surface it stood for. Nothing where the ball is further away than the two surfaces may be from each other.
///
/// All that is between the two surfaces is within their bound of the coarser one. So the ball is led freely, in the old
/// scene, to a place outside of that bound. From there the ball comes back to x_W in the new scene and stops where the
/// new surface is. The place is looked for on straight ways along the normals of the surfaces and against the pull
/// towards p_W. Where no straight way leads out, a god-object is drawn along them. The place furthest from all
/// surfaces is taken. A pocket that winds more than that, as of a line that turns back over several of its steps, is
/// not left.
/// `plan` is planFor()'s of the new scene. Bounded by a fixed number of sweeps, and of ticks of the god-object, for
/// each of at most four surfaces that are exchanged near the ball, each by plan.workBudget; allocation-free. AnyScene:
/// Scene or MovingScene.
template<SceneView AnyScene>
[[nodiscard]] std::optional<Vec3> keepSide(
  const AnyScene& from, const AnyScene& to, const ContactPlan& plan, const Vec3& p_W, const Vec3& x_W) noexcept;

} // namespace palpate
