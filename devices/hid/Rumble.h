// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "haptics/core/DeviceCommand.h"

namespace palpate
{

/// How strongly a device shakes, 0 .. 1 of its largest, and how fast.
struct Vibration
{
  double share = 0.0;
  double period_ms = 20.0;
};

struct RumbleOptions
{
  double maxForce_N = 5.0;        ///< the full scale of a force
  double largestShare = 0.6;      ///< of the device's vibration
  double fullSpeed_m_per_s = 0.1; ///< a hand that slides that fast shakes as strongly as it presses
};

/// Contact and sliding for a device that can only shake: a pulse where contact begins, then a vibration that grows with
/// the force and with how fast the hand slides across it, so that texture is felt in it; a hand that only rests on a
/// surface feels nothing, for a vibration that never ends says nothing. A signal of the command is a shake, too.
/// Deterministic.
class Rumble
{
public:
  explicit Rumble(const RumbleOptions& options) noexcept : options_(options) {}

  /// Now, with the newest command and the hand at p_D [m].
  [[nodiscard]] Vibration next(std::int64_t now_ns, const DeviceCommand& command, const Vec3& p_D) noexcept;

private:
  void watchContact(std::int64_t now_ns, double share) noexcept;
  void watchSignal(std::int64_t now_ns, Signal signal) noexcept;
  [[nodiscard]] double slidingSpeed(std::int64_t now_ns, const Vec3& force_D, const Vec3& p_D) noexcept;

  RumbleOptions options_;
  bool touching_ = false;
  Signal lastSignal_ = Signal::None;
  std::int64_t pulseUntil_ns_ = 0, shakeUntil_ns_ = 0;
  bool placed_ = false;
  Vec3 placedAt_D_ = Vec3::Zero();
  std::int64_t placedAt_ns_ = 0;
  double speed_m_per_s_ = 0.0;
};

} // namespace palpate
