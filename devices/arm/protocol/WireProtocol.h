// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "haptics/core/Types.h"

namespace palpate
{

using WireBytes = std::vector<std::uint8_t>;

/// The content of one message to an arm. A wire sends torques of joints, torques of motors or the force, as it knows
/// them.
struct WireOrder
{
  static constexpr std::size_t motors = 3;

  std::array<double, motors> joint_Nm{};               ///< torque of the joints that have a motor
  std::array<double, motors> motor_Nm{};               ///< torque of these motors
  Wrench wrench_D;                                     ///< on the hand [N, N m]
  std::optional<std::array<std::int16_t, 6>> counters; ///< set them so; without force
};

/// The content of one message from an arm.
struct WireReading
{
  static constexpr std::size_t encoders = 6;

  std::array<double, encoders> encoder{}; ///< counts, or degrees where the wire has them
  std::optional<Pose> pose_D;             ///< of a wire that knows the hand [m]
  std::optional<Twist> velocity_D;        ///< likewise [m/s, rad/s]
  std::uint32_t buttons = 0;
  bool grip = false;
  bool homed = true;       ///< false: places mean nothing yet
  bool calibrated = false; ///< the person has just pressed the device's own calibration button
  std::string stopped;     ///< the device's own reason for giving no force; empty: it gives force
};

/// Where a message lies in bytes that came: `skip` bytes that belong to none, then `length`; 0: more must come.
struct WireFrame
{
  std::size_t skip = 0, length = 0;
};

/// The bytes of one kind of arm. Every method is a pure function of its arguments and takes any bytes.
class WireProtocol
{
public:
  virtual ~WireProtocol() = default;

  /// The request. A torque that is not finite is sent as none, one beyond the wire's range as its end.
  virtual void encode(const WireOrder& order, WireBytes& bytes) const = 0;
  /// The first answer in bytes of a link that keeps no borders of messages.
  [[nodiscard]] virtual WireFrame frame(std::span<const std::uint8_t> bytes) const noexcept
  {
    return { 0, bytes.size() };
  }
  /// None: this is no answer.
  [[nodiscard]] virtual std::optional<WireReading> decode(std::span<const std::uint8_t> answer) const = 0;
  /// A whole message that is about something else than the device: it comes between answers and is passed over.
  [[nodiscard]] virtual bool isOthers(std::span<const std::uint8_t> /*message*/) const { return false; }
  /// The message that is sent once before the first request and has no answer; empty: none.
  [[nodiscard]] virtual WireBytes greeting() const { return {}; }
  /// A guard's bytes: they end the torque also where the link's last message was cut short.
  [[nodiscard]] virtual WireBytes farewell() const
  {
    WireBytes bytes;
    this->encode({}, bytes);
    return bytes;
  }
};

} // namespace palpate
