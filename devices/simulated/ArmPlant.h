// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>

#include "devices/simulated/DeviceModels.h"
#include "devices/simulated/FrictionPlant.h"
#include "haptics/arm/Arm.h"

namespace palpate
{

/// The moving part of an arm at its tip in a posture: along its principal directions it moves as decoupled
/// masses.
struct PrincipalPart
{
  Mat3 directions_D = Mat3::Identity(); ///< columns; the first `count` are directions in which the arm moves
  int count = 3;
  Vec3 mass_kg = Vec3::Zero();          ///< apparent, in ascending order
  Vec3 damping_Ns_per_m = Vec3::Zero(); ///< of the joints, along each
  Vec3 friction_N = Vec3::Zero();       ///< of the joints, in a motion along each
  Mat3 dampingAcross = Mat3::Zero();    ///< damping that couples the directions [N s/m]
};

/// Nothing without a posture, or in one in which the arm cannot move in all its directions. Real-time safe.
[[nodiscard]] std::optional<PrincipalPart> principalPartOf(
  const Arm& arm, const JointVector& q, const Posture& posture) noexcept;

/// Empty, or why the arm cannot be simulated: it needs a joint and a motor for each direction, and inertia at each.
[[nodiscard]] std::string refuseSimulation(const ArmPlan& plan);

/// An arm in a hand: in each period its masses, gravity, damping, friction and the forces of its motion are those of
/// its posture at the beginning, and the motion is exact along the principal directions (FrictionPlant). Joints stop
/// at their ends, and where the links do not close.
class ArmPlant
{
public:
  ArmPlant(const ArmPlan& plan, const HandModel& hand, double period_s);

  /// Sets position and velocity. False where the arm does not reach.
  [[nodiscard]] bool begin(const Vec3& p_D, const Vec3& v_D) noexcept;
  /// One period under a force on the handle from the hand [N] and a command of the host. Real-time safe.
  void step(const Vec3& hand_N, const Wrench& command_D) noexcept;

  [[nodiscard]] const Arm& arm() const noexcept { return this->arm_; }
  [[nodiscard]] const JointVector& joints() const noexcept { return this->q_; }
  [[nodiscard]] const Vec3& position_D() const noexcept { return this->p_D_; }
  [[nodiscard]] const Vec3& speed_D() const noexcept { return this->v_D_; }
  /// The position that the encoders show.
  [[nodiscard]] Vec3 shown_D() const noexcept;

private:
  [[nodiscard]] Vec3 ownForce(const Posture& posture, const Wrench& command_D) const noexcept;
  [[nodiscard]] std::optional<JointVector> jointsAt(const Vec3& p_D) const noexcept;

  Arm arm_;
  HandModel hand_;
  double period_s_;
  JointVector q_;
  Vec3 p_D_ = Vec3::Zero(), v_D_ = Vec3::Zero();
};

} // namespace palpate
