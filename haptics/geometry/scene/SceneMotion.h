// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "haptics/geometry/scene/Scene.h"

namespace palpate
{

/// `next`, whose surfaces come from where they were in `now`, at a share of its motion (0..1), in `motion_s` [s].
///
/// A surface with the same vertices comes from its pose in `now`. A surface whose tree was refitted for the motion from
/// there (SceneBuilder::build with `now`) comes from its pose and from the places that its vertices have in `now`, if
/// both are given in one frame: each vertex goes straight in that frame while the frame moves. Any other surface is at
/// once where `next` has it, and so is everything if `motion_s` is not above 0. Returns `next` itself if nothing moves.
/// A motion starts where the surface is felt, not where the last motion was to end: so no surface jumps when snapshots
/// come early. O(vertices that move).
[[nodiscard]] std::shared_ptr<const Scene> movingFrom(
  const Scene& now, double share, const std::shared_ptr<const Scene>& next, double motion_s);

} // namespace palpate
