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

/// Data exchanged by the reader, the writer and the servo of a pushed device: the newest hand, the newest command,
/// and whether the device is there. The servo never waits.
class HandExchange
{
public:
  struct Hand
  {
    Vec3 p_D = Vec3::Zero(); ///< [m]
    std::uint32_t buttons = 0;
    bool grip = false; ///< its safety switch is closed, as far as it has said so
    Quat q_D = Quat::Identity();
    Twist velocity_D; ///< [m/s, rad/s]; zero where the device does not tell it
  };
  struct Heard
  {
    bool there = false;       ///< now, and all the time since the last call
    std::optional<Hand> hand; ///< none: it has not said yet where the hand is
  };

  explicit HandExchange(HeldTrust trust) : trust_(trust) {}

  /// One thread at a time: the one that holds the device. None: nobody knows where the hand is.
  void tell(const std::optional<Hand>& hand) noexcept;
  /// Any thread.
  [[nodiscard]] bool handKnown() const noexcept { return this->handKnown_; }
  void trust(HeldTrust trust) noexcept { this->trust_ = trust; }

  /// The newest. Servo thread; wait-free.
  [[nodiscard]] Heard heard() noexcept;
  void command(const DeviceCommand& command) noexcept;

  /// The present command of the device. Writer thread.
  [[nodiscard]] PidOutput::Wish wish() noexcept;
  /// From now on nothing, until the servo has asked for no force once: only a person brings it back. Writer thread.
  void mute() noexcept { this->muted_ = true; }

  /// A line of its own: the servo reads it every tick.
  alignas(64) Presence presence;

private:
  TripleBuffer<std::optional<Hand>> handToServo_;
  TripleBuffer<std::optional<Hand>> handToWriter_;
  TripleBuffer<DeviceCommand> commands_;            ///< servo -> writer
  alignas(64) std::atomic<std::uint64_t> beat_ = 0; ///< servo's: commands so far
  alignas(64) std::atomic<HeldTrust> trust_;
  std::atomic<bool> handKnown_ = false;
  bool muted_ = false; ///< writer's
};

} // namespace palpate
