// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "devices/simulated/DeviceModels.h"
#include "devices/simulated/FrictionPlant.h"

namespace palpate
{

/// Rotation of a device's handle in a hand. Its inertia is that of a ball, so that the three axes are decoupled; each
/// is exact over a period about the rotation at its start, and the rotations of successive periods are composed.
class TurningPart
{
public:
  TurningPart(const TurningModel& device, const TurningModel& hand, double period_s);

  void begin(const Quat& turn_D) noexcept;
  /// One period, in which the hand is led from one rotation to another under a torque of the motors [N m].
  void step(const Quat& ledFrom_D, const Quat& ledTo_D, const Vec3& torque_Nm) noexcept;

  [[nodiscard]] const Quat& turn_D() const noexcept { return this->turn_D_; }
  [[nodiscard]] Vec3 rate_D() const noexcept; ///< [rad/s]
  /// The rotation that the encoder shows: each component of the rotation vector in whole steps.
  [[nodiscard]] Quat shown_D() const noexcept;

private:
  TurningModel device_, hand_;
  double period_s_;
  FrictionPlant plant_; ///< in N m, rad, kg m2
  Quat turn_D_ = Quat::Identity();
  std::array<FrictionPlant::State, 3> axes_{};
};

} // namespace palpate
