// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/compliance/servo/SoftSurfaceRef.h"
#include "haptics/contact/view/SceneView.h"

namespace palpate
{

/// Contacts of the ball where the rigid core rests: the planes it touches, then those of `state` that carried force,
/// unless the core is below them: in a valley the core is passed from wall to wall, and one contact would be forgotten
/// and found again in turn. A plane above the core was left over an edge. Edges and vertices stay within a fiftieth of
/// a patch, if their normal is far from every other. Forces of contacts that stay are kept. AnyScene: Scene or
/// MovingScene, both instantiated in SoftContacts.cpp.
template<SceneView AnyScene>
void gatherContacts(
  const AnyScene& scene, std::span<const SoftSurfaceRef> soft, double radius_u, SoftState& state) noexcept;

} // namespace palpate
