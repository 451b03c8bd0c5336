// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "haptics/core/Types.h"

namespace palpate
{

/// The state of the hand at one tick, as measured by a device. Wide from the start: a new device adds values, not
/// fields.
struct DeviceSample
{
  double time_s = 0.0;       ///< tick time of the measurement [s]
  Pose pose_D;               ///< tool in the device frame [m]
  Twist velocity_D;          ///< measured or zero [m/s, rad/s]
  Wrench sensed_D;           ///< force sensor of an admittance device, else zero [N, N m]
  std::uint32_t buttons = 0; ///< bit i: button i + 1 is down
  bool grip = false;         ///< dead-man or grip sensor closed
};

} // namespace palpate
