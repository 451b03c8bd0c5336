// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "haptics/core/DeviceSample.h"
#include "haptics/force/WorkspaceMap.h"
#include "haptics/recording/Recording.h"

namespace palpate
{

/// The hand of a recording, for a device that plays it.
struct RecordedHand
{
  std::vector<DeviceSample> samples; ///< one a tick, from where there was a hand
  /// With it the hand is in the scene where it was. Where the map changed meanwhile, the positions are as if it had
  /// not.
  WorkspaceMap map;
  std::optional<Vec3> ball_W;         ///< where the ball was in the beginning [u], if it was anywhere
  std::vector<std::uint64_t> touched; ///< geometry hashes of all scenes
};

[[nodiscard]] RecordedHand recordedHand(const Recording& recording);

/// The message while a recording is played on other surfaces than the recorded ones; "" while that is not
/// known, or they are the same. `shown`: the geometry hash of the present scene, 0 without one.
[[nodiscard]] std::string otherSceneText(const RecordedHand& hand, std::uint64_t shown);

} // namespace palpate
