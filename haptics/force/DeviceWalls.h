// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>

#include "haptics/core/DeviceCommand.h"

namespace palpate
{

/// A straight wall near the virtual location of a plane world: a touched plane of the god-object, or one not yet
/// reached that the device should close before the host looks again.
struct NearWall
{
  Vec3 normal_D = Vec3::Zero(); ///< unit, in the plane z = 0, towards the virtual location
  double gap_m = 0.0;           ///< >= 0; 0: touched
};

/// At most one wall in each of the directions 0, 90, 180 and 270 degrees, which a force-feedback joystick can
/// hold by itself. Wall i keeps the handle at direction(i) . p_D >= offset_m[i].
struct AxisWalls
{
  static constexpr int count = 4;

  std::array<std::optional<double>, count> offset_m{};

  /// (1, 0), (0, 1), (-1, 0), (0, -1): the normal of wall i, on whose side the handle stays.
  [[nodiscard]] static Vec3 direction(int i) noexcept;
};

/// The walls that keep the handle from going where the virtual location x_D [m] cannot: one in each direction against
/// which a near wall leans, at the first place where a near wall is met along the axis. A slanted wall becomes two that
/// meet at x_D; where the slanted wall is touched, their springs give the handle the same force as a spring to x_D.
/// A wall that leans by no more than `leastLean`, the sine of its angle to the axis, does not count in that direction:
/// so a wall along an axis is one wall in spite of rounding, and the force lost is at most that share of the whole.
[[nodiscard]] AxisWalls wallsAround(const Vec3& x_D, std::span<const NearWall> near, double leastLean = 0.02) noexcept;

/// The walls to hold next. A wall that moves by d into a handle p behind it gives the hand K d (p + d / 2). So a wall
/// enters the hand by at most `most_m` an update, and a new wall begins at the handle. Away from the handle each wall
/// moves at once.
[[nodiscard]] AxisWalls ledTo(
  const AxisWalls& held, const AxisWalls& wanted, const Vec3& handle_D, double most_m) noexcept;

/// Whether `now` is worth sending to a device that holds `sent`: another set of walls, or one that moved by at least
/// `step_m`, the resolution of the device [m].
[[nodiscard]] bool differ(const AxisWalls& sent, const AxisWalls& now, double step_m) noexcept;

/// The walls as part of a command, springs of that stiffness that together push with no more than `largest_N`: of two
/// opposite walls one pushes at a time, and where walls stand across both axes each pushes with at most
/// largest_N / sqrt(2), so that sqrt(F_x^2 + F_y^2) <= largest_N however deep the handle gets before the next update.
void command(const AxisWalls& walls, double stiffness_N_per_m, DeviceCommand& command,
  double largest_N = std::numeric_limits<double>::infinity()) noexcept;

/// Whether all that a device is to close by itself are numbers; a largest force may be infinite, for it cuts nothing.
[[nodiscard]] bool isFinite(const DeviceCommand& command) noexcept;

/// Force of the walls of a command on a handle at rest at p_D [m], in [N].
[[nodiscard]] Vec3 forceOfWalls(const DeviceCommand& command, const Vec3& p_D) noexcept;

/// How a device that holds walls is used. Off by default: whether the device holds them depends on device and world.
struct DeviceWallPlan
{
  bool hold = false;
  double every_s = 0.008;          ///< walls are looked for and moved no more often: the rate of the link
  double step_m = 0.0;             ///< how far a wall must have moved to be sent again
  double viscosity_Ns_per_m = 0.0; ///< of the whole world, so that no corridor shakes (Viscosity.h)

  friend bool operator==(const DeviceWallPlan&, const DeviceWallPlan&) = default;
};

/// How two walls of a device resist a handle that slides along the slanted wall they stand for.
struct Velvet
{
  double mean_N = 0.0;
  double peak_N = 0.0;
};

/// A handle that slides at a steady speed along a slanted wall, pressed against it.
struct Slide
{
  double stiffness_N_per_m = 0.0; ///< of each wall of the device, >= 0
  double speed_m_per_s = 0.0;     ///< >= 0
  double depth_m = 0.0;           ///< of the handle behind the slanted wall, >= 0
  double host_s = 0.0;            ///< between two updates of the walls, a multiple of device_s
  double device_s = 0.0;          ///< period of the device's own loop, > 0
  double lean = 0.0; ///< sine of the angle between the slanted wall and the device's wall it slides into, in (0, 1)
};

/// The drag of such a slide. The corner of the two walls stays behind by s = speed * (time since the update) until the
/// host moves the corner on. While both walls press, the corner pulls back with K s, whatever the angle: a saw tooth
/// with the peak K v (T_host - T_device) and half of that as its mean. From s = depth * lean / sqrt(1 - lean^2) on the
/// handle is off one wall and drags against the other alone, with K lean (depth sqrt(1 - lean^2) + s lean). Both
/// directions along a wall differ by their lean, unless the wall is at 45 degrees. Mean over the periods of the device.
[[nodiscard]] Velvet velvet(const Slide& slide) noexcept;

} // namespace palpate
