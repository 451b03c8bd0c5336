// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "haptics/core/DeviceInfo.h"
#include "haptics/force/WorkspaceMap.h"
#include "haptics/session/scene/BuiltScene.h"

namespace palpate
{

/// The map with which the device's workspace holds the box of a scene: half its diagonal is the workspace's radius, its
/// middle the device's origin. A device that moves in a plane moves in that of a plane world, otherwise the rotation
/// stays. The scene must not be empty.
[[nodiscard]] WorkspaceMap fittedMap(WorkspaceMap map, const BuiltScene& scene, const DeviceInfo& device);

/// The box of all surfaces of these names, where they stand in the end: low and high x, y, z [u]. Empty, or the first
/// name that no surface has; then `bounds` is as before.
[[nodiscard]] std::string boundsOf(
  const Scene* scene, const std::vector<std::string>& names, std::array<double, 6>& bounds);

/// Whether a scene that was committed then is the one that touching began with: shown data are handed over a moment
/// after a touch; data that are shown later do not move the hand [s].
[[nodiscard]] bool isOfTouch(double committed_s, double begun_s);

} // namespace palpate
