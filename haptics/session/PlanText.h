// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "haptics/contact/view/ContactPlan.h"
#include "haptics/geometry/scene/Scene.h"
#include "haptics/geometry/scene/SceneSimplifier.h"

namespace palpate
{

/// The contact plan of a scene, and the settings behind the plan.
struct TouchChoice
{
  ContactPlan plan;                                           ///< as planFor() makes it
  double asked_u = 0.0;                                       ///< radius of the ball that was asked for [u]
  double largest_u = std::numeric_limits<double>::infinity(); ///< RadiusLimit's [u]
  bool frictionFromData = false;                              ///< some surface has friction of its own
};

/// Whether a surface brings friction of its own, from arrays or as a material.
[[nodiscard]] bool hasOwnFriction(const Scene& scene) noexcept;

/// The ball asked for, or if the limit is kept, no larger one than the limit [u].
[[nodiscard]] double chosenRadius_u(double asked_u, double largest_u, bool keepLimit) noexcept;

/// "all 320 triangles are felt (...), by a point (no radius is asked for) without friction (none is asked for), through
/// a tree of boxes (...)": the choices and their reasons, for a person.
[[nodiscard]] std::string planText(const std::vector<SurfaceChoice>& choices, const TouchChoice& touch);

/// "9000 of 79600 triangles are felt, ...": of one surface.
[[nodiscard]] std::string planText(const SurfaceChoice& choice);

} // namespace palpate
