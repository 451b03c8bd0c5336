// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/compliance/servo/SoftTouch.h"
#include "haptics/contact/view/SceneView.h"

namespace palpate
{

/// Of two contacts with nearly one normal, which stays: both would share a load that is one's.
enum class Prefer : std::uint8_t
{
  Found,
  Carrying, ///< once the turns of a tick hand the ball from a face to the next and back
};

/// Contacts of the ball where the rigid core rests: the planes it touches, then those of `state` that carried force,
/// are where the way that they yielded by leaves them, within a fiftieth of a patch, and far from every other normal.
/// Two soft walls yield unequally: without that memory one of them would be forgotten and found again in turn. Forces
/// and depths of contacts that stay are kept. AnyScene: Scene or MovingScene, both instantiated in SoftContacts.cpp.
template<SceneView AnyScene>
void gatherContacts(
  const AnyScene& scene, std::span<const SoftTouch> soft, double radius_u, Prefer prefer, SoftState& state) noexcept;

} // namespace palpate
