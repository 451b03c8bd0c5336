// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "haptics/tick/ForceRenderer.h"

namespace palpate
{

/// Relation of a tick's scene to the previous one.
struct SceneStep
{
  bool otherGeometry = false; ///< other surfaces than before, not only the same in other places
  bool replaced = false;      ///< and they neither go on from where those before were felt nor are of the same whole
  bool changed = false;       ///< another scene, if only of the same surfaces
  bool first = false;         ///< there was none before
  double age_s = 0.0;         ///< of the scene, at the end of this tick
};

[[nodiscard]] SceneStep sceneStep(
  const TickInput& input, const LoadedRegion& known, const RendererState& state) noexcept;

/// Position of the proxy, and the work of its motion with the scene.
struct ProxyStep
{
  ContactResult contact;
  std::uint32_t carryWork = 0;
  bool pinned = false;
};

/// Parameters of the proxy's motion: the plan with this tick's stiffness, from where the ball comes in a new scene or
/// map, whether the map has put the hand elsewhere, whether anything is to be touched.
struct ProxyTick
{
  const TickInput& input;
  const SceneStep& step;
  const ContactPlan& plan;
  const BallLead& lead;
  bool elsewhere = false;
  bool touches = false;
  PathSink* sink = nullptr;
};

/// Takes the proxy along with its scene from the last tick to this one, then towards the device at p_W. Elsewhere it
/// begins anew at the device. Another ball is seated where the old one was, so a pressed one stays on its side; where
/// it does not fit there the old one goes on until it does.
[[nodiscard]] ProxyStep moveProxy(const ProxyTick& tick, const Vec3& p_W, RendererState& state) noexcept;

} // namespace palpate
