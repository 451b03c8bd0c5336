// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "haptics/contact/ContactPlan.h"
#include "haptics/contact/GodObject.h"
#include "haptics/core/Types.h"
#include "haptics/geometry/Scene.h"

namespace palpate
{

/// What friction lets the god-object do in a tick.
struct FrictionVerdict
{
  FrictionMotion motion = FrictionMotion::None;
  int contacts = 0;             ///< that hold it while it sticks
  std::array<HeldPlane, 3> held; ///< and which
  Vec3 pulled_W = Vec3::Zero(); ///< where the device would have to be for the frictionless god-object to go where it goes
};

/// The friction cone of the god-object (Harwin & Melder 2002), in the free directions of all touched planes.
///
/// From where it is, x0, the frictionless god-object would go to xf under the touched planes, with multipliers l_i
/// (depths [u] along the normals). Static friction keeps it at x0 as long as |x0 - xf| <= sum mu_s l_i; then it trails
/// xf by sum mu_k l_i in the direction it came from, until the device no longer draws it on. It moves by being pulled
/// to p + (x - xf): this shift lies in the touched planes, so their depths stay, and every way is swept as without
/// friction. Exact on faces and in corners; over round features exact in the limit of small ticks. Re-linearises the
/// features of `state`; real-time safe.
template<class SceneView>
[[nodiscard]] FrictionVerdict judgeFriction(
  const SceneView& scene, const ContactPlan& plan, const Vec3& p_W, GodObjectState& state) noexcept;

} // namespace palpate
