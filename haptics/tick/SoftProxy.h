// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/compliance/servo/PressedBody.h"
#include "haptics/tick/ForceRenderer.h"
#include "haptics/tick/ProxyStep.h"

namespace palpate
{

/// Moves the ball towards the device at p_W in a scene with a soft body (SoftTick.h), at a share of the scene's motion.
/// The proxy of the result is the ball in the world, the contact of the state the ball among the free surfaces.
[[nodiscard]] ContactResult moveOnBody(
  const ProxyTick& tick, const ContactPlan& plan, const Vec3& p_W, double share, RendererState& state) noexcept;

/// Report of a tick to the worker of the body.
[[nodiscard]] BodyHand bodyHandOf(
  const TickInput& input, const TickOutput& output, const RendererState& state) noexcept;

} // namespace palpate
