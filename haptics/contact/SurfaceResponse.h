// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/contact/ContactPlan.h"
#include "haptics/contact/GodObject.h"
#include "haptics/contact/PosedSurface.h"

namespace palpate
{

/// What pulls the hand towards the surface side of the coupling [u]: proxy - device for plain walls; where surfaces
/// differ, the sum over the planes that hold the ball of their stiffness factor times depth along the normal, and the pull
/// of friction with the mean factor.
///
/// A texture of height h(x) moves the constraint out: the spring's energy K (d + h)^2 / 2 is a potential, so its force
/// K (d + h) (n - grad h) takes nothing and gives nothing over a closed way. A hand that passes more than a fifth of a
/// grain in a tick gets the texture smaller in proportion, and none where it could only buzz.
template<class SceneView>
[[nodiscard]] Vec3 respond(const SceneView& scene, const ContactPlan& plan, const ContactResult& contact, const Vec3& p_W,
  double step_u) noexcept;

} // namespace palpate
