// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/hid/SpaceMouseInput.h"
#include "haptics/core/Types.h"

namespace palpate
{

struct CapMotionOptions
{
  double radius_m = 0.1;      ///< of the ball in which the hand moves
  double speed_m_per_s = 0.1; ///< of a fully pressed cap
  double turn_rad_per_s = 1.5;
  double restShare = 0.02; ///< smallest share of the full deflection that counts as a press: springs age
};

/// Pose of a hand that a SpaceMouse moves: its cap travels a millimetre only, so a press is a velocity, and the pose is
/// its integral. D has x to the right, y away from the person and z up; HID has y towards the person and z down,
/// rotations right-handed about its axes: D is HID rotated by half a turn about x. Real-time safe; deterministic.
class CapMotion
{
public:
  explicit CapMotion(const CapMotionOptions& options = {}) noexcept : options_(options) {}

  /// Advances the pose by `dt_s` under that press.
  void step(const Cap& cap, double dt_s) noexcept;
  [[nodiscard]] const Pose& pose_D() const noexcept { return this->pose_D_; }
  /// Velocity in the last step.
  [[nodiscard]] const Twist& velocity_D() const noexcept { return this->velocity_D_; }

private:
  [[nodiscard]] double pressed(double share) const noexcept;

  CapMotionOptions options_;
  Pose pose_D_;
  Twist velocity_D_;
};

} // namespace palpate
