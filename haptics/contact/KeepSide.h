// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "haptics/contact/ContactPlan.h"
#include "haptics/contact/PosedSurface.h"
#include "haptics/core/Types.h"

namespace palpate
{

/// Where a ball belongs after a surface has given way to one that it stands for, or that stands for it; nothing where
/// it is further from it than the two may be from each other.
///
/// What is between two such surfaces is within their bound of the coarser one. So the ball is led straight and freely,
/// by the old scene, to a place out of that: from there it comes back to x_W in the new scene and stops where the
/// surface now is. It is looked for along the normals of the surfaces and against the pull towards p_W; the place that
/// is furthest from all of them is taken. A pocket of the old surface without a straight way out is not left.
/// `plan` is planFor()'s of the new scene. Bounded by a fixed number of sweeps a surface that is exchanged near the
/// ball, each by plan.nodeBudget; allocation-free. SceneView: Scene or MovingScene.
template<class SceneView>
[[nodiscard]] std::optional<Vec3> keepSide(
  const SceneView& from, const SceneView& to, const ContactPlan& plan, const Vec3& p_W, const Vec3& x_W) noexcept;

} // namespace palpate
