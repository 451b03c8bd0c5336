// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>

#include "devices/hid/pid/PidOutput.h"
#include "devices/io/Presence.h"
#include "haptics/core/DeviceCommand.h"
#include "haptics/realtime/TripleBuffer.h"

namespace palpate
{

/// Data exchanged by the reader, the writer and the servo of a device with a link: the newest hand, the newest command,
/// and whether the device is there. The servo never waits.
class HandExchange
{
public:
  struct Hand
  {
    Vec3 p_D = Vec3::Zero(); ///< [m]
    std::uint32_t buttons = 0;
    bool grip = false; ///< its safety switch is closed, by its last report
    Quat q_D = Quat::Identity();
    Twist velocity_D; ///< [m/s, rad/s]; zero where the device does not report it
  };
  struct Heard
  {
    bool there = false;       ///< the device is present, and was since the last call
    std::optional<Hand> hand; ///< none: no position was reported yet
  };

  explicit HandExchange(HeldTrust trust) : trust_(trust) {}

  /// Publishes the hand; none: its position is unknown. One thread at a time: the one that has the device.
  void tell(const std::optional<Hand>& hand) noexcept;
  /// Any thread.
  [[nodiscard]] bool handKnown() const noexcept { return this->handKnown_; }
  void trust(HeldTrust trust) noexcept { this->trust_ = trust; }

  /// Presence and the newest hand. Servo thread; wait-free.
  [[nodiscard]] Heard heard() noexcept;
  void command(const DeviceCommand& command) noexcept;

  /// The present command of the device. Writer thread.
  [[nodiscard]] PidOutput::Wish wish() noexcept;
  /// Sends no force until the servo has commanded no force once, so that only the user brings it back. Writer thread.
  void mute() noexcept { this->muted_ = true; }

  /// On a cache line of its own: the servo reads it every tick.
  alignas(64) Presence presence;

private:
  TripleBuffer<std::optional<Hand>> handToServo_;
  TripleBuffer<std::optional<Hand>> handToWriter_;
  TripleBuffer<DeviceCommand> commands_;            ///< servo -> writer
  alignas(64) std::atomic<std::uint64_t> beat_ = 0; ///< servo's: number of commands
  alignas(64) std::atomic<HeldTrust> trust_;
  std::atomic<bool> handKnown_ = false;
  bool muted_ = false; ///< writer's
};

} // namespace palpate
