// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>

#include "devices/simulated/DeviceModels.h"
#include "devices/simulated/MovingPart.h"
#include "devices/simulated/PrincipalPlant.h"
#include "haptics/arm/Arm.h"

namespace palpate
{

/// The moving part of an arm at its tip in a posture, with the damping and friction of its joints; masses in ascending
/// order. Nothing without a posture, or in one in which the arm cannot move in all its directions. Real-time safe.
[[nodiscard]] std::optional<PrincipalPart> principalPartOf(
  const Arm& arm, const JointVector& q, const Posture& posture) noexcept;

/// Empty, or why the arm cannot be simulated: it needs a joint and a motor for each direction, and inertia at each.
[[nodiscard]] std::string refuseSimulation(const ArmPlan& plan);

/// An arm in a hand: in each period its masses, gravity, damping, friction and the forces of its motion are those of
/// its posture at the beginning (PrincipalPlant). Joints stop at their ends, and where the links do not close.
class ArmPlant final : public MovingPart
{
public:
  ArmPlant(const ArmPlan& plan, const HandModel& hand, double period_s);

  [[nodiscard]] bool begin(const Vec3& p_D, const Vec3& v_D) noexcept override;
  void step(const Vec3& hand_N, const Wrench& motors_D) noexcept override;
  [[nodiscard]] Vec3 shown_D() const noexcept override;

  [[nodiscard]] const Arm& arm() const noexcept { return this->arm_; }
  [[nodiscard]] const JointVector& joints() const noexcept { return this->q_; }

private:
  [[nodiscard]] Vec3 ownForce(const Posture& posture, const Wrench& motors_D) const noexcept;
  [[nodiscard]] std::optional<JointVector> jointsAt(const Vec3& p_D) const noexcept;

  Arm arm_;
  HandModel hand_;
  double period_s_;
  JointVector q_;
};

} // namespace palpate
