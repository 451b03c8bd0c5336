// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/core/DeviceCommand.h"

namespace palpate
{

/// A link with a limited rate of bytes from the host to the device. Only changes are sent, one message
/// after another, each with the newest command when the link becomes free; a message acts once its last byte has
/// arrived. Sizes are those of the SideWinder Force Feedback Pro's link of 31,250 baud (10 bits a byte), as the public
/// firmware of adapt-ffb-joy writes them: a parameter of 14 bits takes three bytes of address and three of value.
class SerialLink
{
public:
  static constexpr double parameter_B = 6.0;
  static constexpr double force_B = 2 * parameter_B; ///< its direction and its magnitude
  static constexpr double walls_B = 4 * parameter_B; ///< the offsets of four walls

  /// Infinite: each command arrives at once.
  explicit SerialLink(double bytes_per_s) noexcept : bytes_per_s_(bytes_per_s) {}

  /// Offers a command and returns the one that acts at that time [s]; times never go back. Real-time safe.
  [[nodiscard]] const DeviceCommand& carry(const DeviceCommand& offered, double time_s) noexcept;

  /// Size of the change from one command to another [bytes]: offsets and stiffnesses of walls by their direction, the
  /// viscosity, the force.
  [[nodiscard]] static double bytesBetween(const DeviceCommand& before, const DeviceCommand& after) noexcept;

private:
  void send(const DeviceCommand& command, double time_s) noexcept;

  double bytes_per_s_;
  DeviceCommand there_, onItsWay_, waiting_;
  bool busy_ = false;
  double arrives_s_ = 0.0;
};

} // namespace palpate
