// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "haptics/core/Types.h"

namespace palpate
{

/// A half-space wall that the device closes itself: the handle stays where normal_D . p_D >= offset_m.
struct DeviceWall
{
  Vec3 normal_D = Vec3::Zero();
  double offset_m = 0.0;
  double stiffness_N_per_m = 0.0;
  double largest_N = std::numeric_limits<double>::infinity(); ///< no harder, however deep the handle is
};

/// A short effect the hand feels once when it is asked for after it was not, and no longer than it is asked for.
enum class Signal : std::uint8_t
{
  None,
  Oscillation,
};

/// Where a device that closes the spring of contact itself draws the hand to. From where the hand is, it then gives the
/// command's force, with all limits in it. How the hand is turned stays as it is: there is no spring that turns yet.
struct PoseTarget
{
  Pose pose_D;                    ///< [m]
  double stiffness_N_per_m = 0.0; ///< of that spring; 0: there is none, and the pose is where the hand is
};

/// The servo's command to a device for one tick.
struct DeviceCommand
{
  std::uint32_t hand = 0; ///< whose it is, from 0
  Wrench wrench_D;        ///< force on the hand [N], torque [N m]
  PoseTarget target;
  std::array<DeviceWall, 4> walls{}; ///< the first wallCount are valid
  std::uint8_t wallCount = 0;
  /// From the axes along which walls stand to those of the force, for walls that the host closes: they differ where a
  /// calibration has turned a motor.
  Mat3 wallMotors = Mat3::Identity();
  double viscosity_Ns_per_m = 0.0;
  double brakeLargest_N = std::numeric_limits<double>::infinity(); ///< viscosity brakes no harder
  bool lapses = false; ///< commands are no longer renewed, so that they must expire in the device
  Signal signal = Signal::None;
};

} // namespace palpate
