// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/contact/view/ContactPlan.h"
#include "haptics/contact/view/GodObjectState.h"
#include "haptics/core/Types.h"
#include "haptics/geometry/scene/Scene.h"

namespace palpate
{

class MovingScene;

/// Moves the god-object towards the device point p_W [u] and reports where it rests.
///
/// Zilles & Salisbury 1995 for the idea, Ruspini, Kolarov & Khatib 1997 for the ball; one plane per
/// touched feature, which constrains only while that feature supports the ball.
/// At rest p - x lies in the normal cone of the touched features. Deterministic and independent of the order of
/// triangles; allocates nothing, locks nothing, asks no clock. Bounded by plan.passCap passes and plan.workBudget units
/// of work a run: one without friction and shading, which take a bounded number of runs each. Where there are curves a
/// point is a ball too small to matter (PlanFor.h). The first call places the ball at p_W, moved out of a surface it
/// overlaps to the side of its centre.
[[nodiscard]] ContactResult moveGodObject(const Scene& scene, const ContactPlan& plan, const Vec3& p_W,
  GodObjectState& state, PathSink* sink = nullptr) noexcept;

/// The same at a moment of a scene that moves. CarryBall moves the ball with moving surfaces.
[[nodiscard]] ContactResult moveGodObject(const MovingScene& scene, const ContactPlan& plan, const Vec3& p_W,
  GodObjectState& state, PathSink* sink = nullptr) noexcept;

} // namespace palpate
