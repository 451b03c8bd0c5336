// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/core/Types.h"

namespace palpate
{

/// The part of a simulated device that hand and motors move: a PrincipalPlant, the same everywhere (MassPart) or
/// another one at each place (ArmPlant).
class MovingPart
{
public:
  virtual ~MovingPart() = default;

  /// Sets position and velocity [m, m/s]. False where the part does not reach.
  [[nodiscard]] virtual bool begin(const Vec3& p_D, const Vec3& v_D) noexcept = 0;
  /// One period under a force of the hand on the handle [N] and a command for the motors. Real-time safe.
  virtual void step(const Vec3& hand_N, const Wrench& motors_D) noexcept = 0;
  /// The position that the encoders show.
  [[nodiscard]] virtual Vec3 shown_D() const noexcept = 0;

  [[nodiscard]] const Vec3& position_D() const noexcept { return this->p_D_; }
  [[nodiscard]] const Vec3& speed_D() const noexcept { return this->v_D_; }

protected:
  Vec3 p_D_ = Vec3::Zero(), v_D_ = Vec3::Zero();
};

} // namespace palpate
