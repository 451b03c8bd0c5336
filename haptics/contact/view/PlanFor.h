// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "haptics/contact/view/ContactPlan.h"
#include "haptics/geometry/scene/Scene.h"

namespace palpate
{

/// Radius of the ball that stands for a point where there are curves, as a share of the thinnest curve's.
inline constexpr double pointOfCurve = 1e-3;

/// The ball that touches this scene. A point is stopped by faces in exact arithmetic and rolls round nothing; a curve
/// can only be rolled round. So where there are curves a point becomes a ball of a thousandth of the thinnest curve,
/// and both are touched by the same steps. Surfaces are then felt from so much further off: at a curve of 1 mm and 1000
/// N/m that is 1 mN.
[[nodiscard]] inline ContactPlan planFor(const Scene& scene, ContactPlan plan) noexcept
{
  plan.radius_u = std::max(plan.radius_u, pointOfCurve * scene.leastCoat_u());
  return plan;
}

} // namespace palpate
