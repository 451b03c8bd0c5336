// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/contact/view/ContactPlan.h"
#include "haptics/contact/view/GodObjectState.h"
#include "haptics/contact/view/SceneView.h"
#include "haptics/core/Types.h"

namespace palpate
{

/// After the scene changed: features of surfaces that are still there, by content, are kept, and so are those whose
/// corners are where they were in a surface that is another part of the same (sameFeature()). Near a surface that was
/// replaced by a simpler one, or to the one that it stood for, the ball stays on its side (keepSide()). If a touched
/// surface is gone otherwise, its successor is looked for from outside, along the force and no further than twice the
/// penetration, so that a pressed ball stays on its side. True if that left no room for the ball (carryWithVertices()).
/// Bounded and allocation-free; both scenes must be alive.
[[nodiscard]] bool handOver(
  const Scene& from, const Scene& to, const ContactPlan& plan, const Vec3& p_W, GodObjectState& state) noexcept;

/// The same between two moments of scenes that move.
[[nodiscard]] bool handOver(const MovingScene& from, const MovingScene& to, const ContactPlan& plan, const Vec3& p_W,
  GodObjectState& state) noexcept;

} // namespace palpate
