// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/compliance/servo/SoftTouch.h"
#include "haptics/contact/view/SceneView.h"

namespace palpate
{

/// Contacts of the ball where the rigid core rests: the planes it touches, then those of `state` that carried force,
/// are within a fiftieth of a patch and far from every other normal. Two soft walls yield unequally: without that
/// memory one of them would be forgotten and found again in turn. Forces and depths of contacts that stay are kept.
/// AnyScene: Scene or MovingScene, both instantiated in SoftContacts.cpp.
template<SceneView AnyScene>
void gatherContacts(const AnyScene& scene, std::span<const SoftTouch> soft, double radius_u, SoftState& state) noexcept;

} // namespace palpate
