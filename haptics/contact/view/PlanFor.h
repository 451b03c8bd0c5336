// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "haptics/contact/view/ContactPlan.h"
#include "haptics/geometry/scene/Scene.h"

namespace palpate
{

/// Of the thinnest curve, how large a point is taken to be where there are curves.
inline constexpr double pointOfCurve = 1e-3;

/// The ball that touches this scene. A point is stopped by faces in exact arithmetic and rolls round nothing, a curve
/// can only be rolled round: where there are curves a point becomes a ball of a thousandth of the thinnest one, so that
/// both are touched by the same steps. It is felt by so much further off, which at a curve of 1 mm and 1000 N/m is
/// 1 mN.
[[nodiscard]] inline ContactPlan planFor(const Scene& scene, ContactPlan plan) noexcept
{
  plan.radius_u = std::max(plan.radius_u, pointOfCurve * scene.leastCoat_u());
  return plan;
}

} // namespace palpate
