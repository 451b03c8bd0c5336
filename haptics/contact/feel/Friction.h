// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "haptics/contact/planes/ContactSet.h"
#include "haptics/contact/view/ContactPlan.h"
#include "haptics/contact/view/GodObjectState.h"
#include "haptics/core/Types.h"
#include "haptics/geometry/scene/Scene.h"

namespace palpate
{

/// Sums of mu l over the planes that hold: radii of the discs in which the god-object may rest, and trail [u].
struct FrictionReach
{
  double statical = 0.0, kinetic = 0.0;
};
template<SceneView AnyScene>
[[nodiscard]] FrictionReach reachOf(const AnyScene& scene, const ContactPlan& plan, ContactSet<AnyScene>& contacts,
  const ProjectionResult& held) noexcept;

/// False without friction: none in the plan, and no surface that has one of its own.
template<SceneView AnyScene>
[[nodiscard]] bool frictionMatters(const AnyScene& scene, const ContactPlan& plan) noexcept
{
  return !plan.friction.none() || sceneOf(scene).hasMaterials();
}

/// The planes of a projection that hold, with their depths. Returns how many.
template<SceneView AnyScene>
int listHeld(ContactSet<AnyScene>& contacts, const ProjectionResult& held, std::array<ActivePlane, 3>& planes) noexcept
{
  for (int k = 0; k < held.count; ++k)
  {
    const auto at = static_cast<std::size_t>(k);
    planes[at] = { contacts.feature(held.active[at]), held.lambda[at] };
  }
  return held.count;
}

/// The motion of the god-object that friction allows in a tick.
struct FrictionVerdict
{
  FrictionState motion = FrictionState::None;
  int contacts = 0;                ///< that hold it while it sticks
  std::array<ActivePlane, 3> held; ///< and which
  Vec3 pulled_W =
    Vec3::Zero(); ///< where the device would have to be for the frictionless god-object to go where it goes
};

/// The friction cone of the god-object (Harwin & Melder 2002), in the free directions of all touched planes.
///
/// From its place x0 the frictionless god-object would go to xf under the touched planes, with multipliers l_i
/// (depths [u] along the normals). Static friction keeps the ball at x0 as long as |x0 - xf| <= sum mu_s l_i. Then the
/// ball trails xf by sum mu_k l_i in the direction it came from, until the device no longer draws it on. The ball is
/// pulled to p + (x - xf): this shift lies in the touched planes, so their depths stay, and every way is swept as
/// without friction. Exact on faces and in corners; over round features exact in the limit of small ticks.
/// Re-linearises the features of `state`; real-time safe.
template<SceneView AnyScene>
[[nodiscard]] FrictionVerdict judgeFriction(
  const AnyScene& scene, const ContactPlan& plan, const Vec3& p_W, GodObjectState& state) noexcept;

} // namespace palpate
