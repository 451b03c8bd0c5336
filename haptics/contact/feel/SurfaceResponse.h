// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/contact/view/ContactPlan.h"
#include "haptics/contact/view/GodObjectState.h"
#include "haptics/contact/view/SceneView.h"

namespace palpate
{

/// The response of the coupling where surfaces differ.
struct Response
{
  Vec3 pull_W = Vec3::Zero(); ///< the displacement that the coupling multiplies with its stiffness [u]
  double held_u2 = 0.0;       ///< the energy it holds, over half its stiffness [u^2]
};

/// Over the planes that hold the ball the coupling is a spring. Its stiffness is the share s(x) that a wall of that
/// material leaves of the coupling's. The spring is stretched by the depth d less the hollow of the texture, c(x) =
/// largest height - height. Along the surface friction pulls with the mean share. Share and hollow are fields over the
/// surface, so the force of the energy K s max(0, d - c)^2 / 2 has a part along the surface,
///
///     F = K s (d - c) (n + grad c) - K (d - c)^2 / 2 grad s,
///
/// and takes nothing and gives nothing over a closed way. Without that part a hand that goes in where a wall is soft
/// and comes out where the wall is hard would be paid for it. A surface is met at d = 0, wherever that is. Were the
/// texture to stand out of the surface, d + h instead of d - c, a hand would be given K s h^2 / 2 on touching and could
/// leave elsewhere. While friction holds the ball, the slopes are those where the ball stands, however the hand moves:
/// there a small closed way of the hand can take or give their force times that way.
///
/// A texture of period L is felt up to the speed at which a period takes ten ticks. From there its height goes to the
/// mean, and is the mean when a period takes five: a faster texture could only buzz. At any one speed that is a
/// potential too. The share of the texture changes with the speed only where the change leaves the coupling no more
/// energy than it held: the texture fades above its mean and returns below its mean, so that no change of speed pays
/// either.
///
/// `step_W`: way of the hand in the tick. `texture`: the share felt in the last tick, below 0 if nothing was held;
/// becomes that of this one.
template<SceneView AnyScene>
[[nodiscard]] Response respond(const AnyScene& scene, const ContactPlan& plan, const ContactResult& contact,
  const Vec3& p_W, const Vec3& step_W, double& texture) noexcept;

} // namespace palpate
