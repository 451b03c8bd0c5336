// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/compliance/servo/SoftSurfaceRef.h"
#include "haptics/contact/view/SceneView.h"

namespace palpate
{

/// Contacts of the ball where the rigid core rests: the planes it touches, then those of `state` that carried force and
/// that it is not below: in a valley it is handed from wall to wall, and one would be forgotten and found again in
/// turn. A plane that it is below it has left over an edge. Edges and vertices count on within a fiftieth of a patch,
/// far from every other normal. Forces of contacts that stay are kept. AnyScene: Scene or MovingScene, both
/// instantiated in SoftContacts.cpp.
template<SceneView AnyScene>
void gatherContacts(
  const AnyScene& scene, std::span<const SoftSurfaceRef> soft, double radius_u, SoftState& state) noexcept;

} // namespace palpate
