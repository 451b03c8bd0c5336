// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "devices/common/Condition.h"
#include "devices/hid/pid/PidEngine.h"
#include "haptics/core/DeviceCommand.h"

namespace palpate
{

/// The physical meaning of a joystick's shares. PID does not say any of it: measured, or assumed.
struct PidScale
{
  double halfTravel_m = 0.05;
  double maxForce_N = 5.0;
  double springStiffness_N_per_m = 100.0; ///< of a spring's coefficient of 1: full force at full travel
  double damperViscosity_Ns_per_m = 5.0;  ///< of a damper's coefficient of 1

  /// The device frame D has x to the right and y away from the person; HID has y towards the person. Axis 0 or 1.
  [[nodiscard]] static double sign(int axis) noexcept { return axis == 0 ? 1.0 : -1.0; }
  [[nodiscard]] double toMetres(int axis, double share) const noexcept
  {
    return sign(axis) * share * this->halfTravel_m;
  }
};

/// Which walls of a command a device holds by itself, and how.
struct WallPlan
{
  std::array<Condition, 2> springs{}; ///< of the x and the y axis, in shares along HID's axes
  std::array<bool, 4> held{};         ///< wall i of the command; the host closes the others
};

/// At most two walls along each axis become one condition: centre in the middle of the corridor, a dead band of half
/// its width. With two coefficients but no dead band a device holds one wall along each axis, the lower one in HID's
/// direction; with neither none. Each side pushes no harder than its wall may, nor than `largestShare` of the device's
/// force; a device that cannot limit a condition's force holds none: that force would have no limit. Walls along no
/// axis, a second one the same way, and walls that leave no space between them stay with the host.
[[nodiscard]] WallPlan planWalls(const DeviceCommand& command, const PidScale& scale,
  const ConditionAbilities& abilities, double largestShare) noexcept;

/// Force [N] in D of the walls that the device does not hold, on a handle at p_D [m].
[[nodiscard]] Vec3 hostWallForce(const DeviceCommand& command, const WallPlan& plan, const Vec3& p_D) noexcept;

/// The command's viscosity, the same along both axes.
[[nodiscard]] Condition planDamper(const DeviceCommand& command, const PidScale& scale, double largestShare) noexcept;

} // namespace palpate
