// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "haptics/core/Types.h"
#include "haptics/recording/Recording.h"

namespace palpate
{

/// Hand, proxy and forces of one tick.
struct TrajectoryPoint
{
  std::uint64_t tick = 0;
  double time_s = 0.0;         ///< since the first tick of the recording, by the periods of the servo
  Vec3 hand_W = Vec3::Zero();  ///< [u]
  Vec3 proxy_W = Vec3::Zero(); ///< [u]
  Vec3 force_W = Vec3::Zero(); ///< that the device was told [N]; walls that it holds itself push beside it
  double lateness_s = 0.0;     ///< periods that were missed before the tick
  double stiffnessShare = 1.0; ///< of the stiffness that lateness left
  double excess_J = 0.0;       ///< energy that the contact has given too much
  std::int32_t contacts = 0;

  [[nodiscard]] double depth_u() const noexcept { return (this->proxy_W - this->hand_W).norm(); }
};

/// The path of the hand through a recording, in the order of its ticks; the touched surfaces need not be there. A tick
/// whose sample could not be used has no point, but its period counts.
[[nodiscard]] std::vector<TrajectoryPoint> trajectoryOf(const Recording& recording);

} // namespace palpate
