// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/core/DeviceInfo.h"
#include "haptics/force/WorkspaceMap.h"
#include "haptics/session/scene/BuiltScene.h"

namespace palpate
{

/// The map with which the device's workspace holds the box of a scene: half its diagonal is the workspace's radius, its
/// middle the device's origin. A device that moves in a plane moves in that of a plane world, otherwise the rotation
/// stays. The scene must not be empty.
[[nodiscard]] WorkspaceMap fittedMap(WorkspaceMap map, const BuiltScene& scene, const DeviceInfo& device);

/// Whether a scene that was committed then is the one that touching began with: what is shown is handed over a moment
/// after a touch, what is shown later does not move the hand [s].
[[nodiscard]] bool isOfTouch(double committed_s, double begun_s);

} // namespace palpate
