// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "devices/common/Condition.h"
#include "devices/simulated/DeviceModels.h"
#include "devices/simulated/LedPath.h"
#include "devices/simulated/MovingPart.h"
#include "devices/simulated/SerialLink.h"
#include "devices/simulated/TurningPart.h"
#include "haptics/core/HapticDevice.h"

namespace palpate
{

/// Options of a simulated device.
struct SimulationOptions
{
  static constexpr int longestDelay_ticks = 16;

  double period_s = 1e-3;         ///< 20 Hz to 8 kHz and beyond
  int delay_ticks = 0;            ///< a command takes effect so many periods late, 0 .. longestDelay_ticks
  Vec3 push_D = Vec3::Zero();     ///< constant force of the hand [N]
  Vec3 velocity_D = Vec3::Zero(); ///< at the start [m/s]
};

/// A device in the grip of a spring-damper hand that is led along a polyline, or without a hand: deterministic, exact
/// between ticks, with friction, encoder steps, delay, force limit and stops. A joystick renders the walls of a command
/// and its viscosity in its own loop, however slow the host is; bare springs are switched with each
/// command, and a serial link limits the data. A device with an encoder shows
/// floor(x / D) D and no velocity, which the host has to estimate. A device without encoder shows both exactly.
class SimulatedDevice final : public HapticDevice
{
public:
  /// Without a hand (its stiffness, damping and mass are zero) the path only has the position where the device starts.
  SimulatedDevice(DeviceModel model, HandModel hand, HandPath path, const SimulationOptions& options = {});

  [[nodiscard]] const DeviceInfo& info() const noexcept override { return this->info_; }
  /// Needs at least one point, all finite, a positive speed, a period and a delay within their limits.
  [[nodiscard]] std::string open() override;
  void close() noexcept override {}
  [[nodiscard]] DeviceStatus read(double tickTime_s, DeviceSample& sample) noexcept override;
  void write(const DeviceCommand& command) noexcept override;

  /// The position to which the hand is led at a time since the start [s], in D.
  [[nodiscard]] Vec3 target(double time_s) const noexcept { return this->path_.at_D(time_s).p; }

  /// From the next period on the hand is led here instead of along its path, for a program that decides as it goes [m].
  void lead(const Vec3& target_D) noexcept;
  /// Likewise, with a rotation.
  void lead(const Pose& target_D) noexcept;

  /// The buttons that the hand holds down from now on, bit i: button i + 1.
  void press(std::uint32_t buttons) noexcept { this->buttons_ = buttons; }

  /// The true state, which an encoder does not show [m, m/s].
  [[nodiscard]] const Vec3& position_D() const noexcept { return this->part_->position_D(); }
  [[nodiscard]] const Vec3& speed_D() const noexcept { return this->part_->speed_D(); }
  /// Nothing: the device does not rotate.
  [[nodiscard]] const std::optional<TurningPart>& turning() const noexcept { return this->turning_; }

private:
  [[nodiscard]] std::string refusal() const;
  void advance() noexcept;
  /// The poses between which the hand is led in the coming period.
  [[nodiscard]] std::pair<Pose, Pose> ledAlong() noexcept;
  /// The command that is due after the delay.
  [[nodiscard]] DeviceCommand due() noexcept;
  /// The spring with which the device renders the wall.
  [[nodiscard]] Condition springOf(const DeviceWall& wall) const noexcept;
  /// The present force of the motors: the command's force and the walls and viscosity that the device renders itself,
  /// limited to the largest force.
  [[nodiscard]] Vec3 motorForce(const DeviceCommand& command) const noexcept;

  DeviceInfo info_;
  DeviceModel model_;
  HandModel hand_;
  LedPath path_;
  SimulationOptions options_;
  int parts_; ///< of a period: passes of the device's own loop, or one
  std::unique_ptr<MovingPart> part_;
  Pose programmed_D_;                  ///< pose to which a program leads the hand [m]
  Pose reached_D_;                     ///< the same in the period before
  bool led_ = false;                   ///< by a program
  std::optional<TurningPart> turning_; ///< none: the device does not rotate
  std::array<DeviceCommand, SimulationOptions::longestDelay_ticks + 1> commands_; ///< of the last periods
  int newest_ = 0;
  SerialLink link_;
  std::uint32_t buttons_ = 0;
  double time_s_ = 0.0;
};

} // namespace palpate
