// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "haptics/arm/ArmPlan.h"

namespace palpate
{

struct ChainGoal;

/// The kinematics of an arm in the device frame D. All functions are noexcept, free of allocation and bounded, so that
/// the servo may call them; none of them returns a number that is not finite.
class Arm
{
public:
  /// The plan must be one that refuse() accepts.
  explicit Arm(const ArmPlan& plan);

  [[nodiscard]] const ArmPlan& plan() const noexcept { return this->plan_; }
  [[nodiscard]] int joints() const noexcept { return this->joints_; } ///< that are sensed
  [[nodiscard]] int motors() const noexcept { return this->motors_; } ///< on the first joints
  /// Directions in which it pushes: 2 in the plane z = 0, else 3.
  [[nodiscard]] int directions() const noexcept { return this->directions_; }
  /// These directions in D, a column each.
  [[nodiscard]] Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3> movedDirections() const noexcept
  {
    return this->turn_D_.leftCols(this->directions_);
  }

  /// Angles of the joints from counts of the encoders [rad].
  [[nodiscard]] JointVector jointsOf(const JointCounts& counts) const noexcept;
  /// The same from turns of the encoders since count 0 [rad].
  [[nodiscard]] JointVector jointsOfEncoders(const JointVector& encoders_rad) const noexcept;
  /// Counts of the encoders with these joints, rounded down. 0 for an encoder that reports angles.
  [[nodiscard]] JointCounts countsOf(const JointVector& q) const noexcept;
  /// Angles as the encoders show them: in whole counts.
  [[nodiscard]] JointVector shown(const JointVector& q) const noexcept;

  [[nodiscard]] bool withinLimits(const JointVector& q) const noexcept;

  /// Pose of the tip and Jacobian at once. Joints that are not finite, and those with which the links do not close,
  /// have no posture.
  [[nodiscard]] Posture posture(const JointVector& q) const noexcept;
  /// The same of the place that carries the wrist, with the rotation of its link (Wrist.h); of the tip without a wrist.
  [[nodiscard]] Posture carrier(const JointVector& q) const noexcept;
  /// The pose of the tip alone.
  [[nodiscard]] std::optional<Pose> forward(const JointVector& q) const noexcept;
  [[nodiscard]] ArmJacobian jacobian(const JointVector& q) const noexcept { return this->posture(q).jacobian; }

  /// A point of a link, given as ArmMass says, and its Jacobian, which is zero where the arm has no posture.
  [[nodiscard]] LinkPoint linkPoint(const JointVector& q, int link, const Vec3& at) const noexcept;

  /// Joints for a position of the tip; nothing if the position is out of reach or beyond the limits. A chain and an arm
  /// with a wrist are solved iteratively from `near`, then from other joints within their limits.
  [[nodiscard]] std::optional<JointVector> inverse(const Vec3& p_D) const noexcept;
  [[nodiscard]] std::optional<JointVector> inverse(const Vec3& p_D, const JointVector& near) const noexcept;
  /// Likewise for a pose of the tip, for a chain of six joints and for an arm with a wrist.
  [[nodiscard]] std::optional<JointVector> inverse(const Pose& tip_D, const JointVector& near) const noexcept;

  /// Torque of the joints for a wrench on the hand, at the tip: J^T w [N m]. 0 for joints without motor.
  [[nodiscard]] JointVector torqueOf(const JointVector& q, const Wrench& wrench_D) const noexcept;
  [[nodiscard]] JointVector torqueOf(const Posture& posture, const Wrench& wrench_D) const noexcept;
  /// Torque of the motors for torques of the joints [N m].
  [[nodiscard]] JointVector motorTorqueOf(const JointVector& torque_Nm) const noexcept;
  /// The share of these torques that every motor can give, 0 .. 1.
  [[nodiscard]] double shareWithinMotors(const JointVector& torque_Nm) const noexcept;

  /// Factor on the force, 0 .. 1: 0 at a joint's end and at the largest condition number of the Jacobian that the plan
  /// allows, rising to 1 over 5 % of the joint's range and of that number.
  [[nodiscard]] double forceFade(const JointVector& q, const Posture& posture) const noexcept;

  /// Torque of the joints for a command: the torque of the wrench times forceFade(), plus `beside`. The sum is scaled
  /// to the largest torque that every motor can give.
  [[nodiscard]] JointVector givenTorqueOf(
    const JointVector& q, const Wrench& wrench_D, const JointVector& beside_Nm) const noexcept;
  /// The same where the posture with these joints is known: it costs more than the rest.
  [[nodiscard]] JointVector givenTorqueOf(
    const JointVector& q, const Posture& posture, const Wrench& wrench_D, const JointVector& beside_Nm) const noexcept;

  /// Matrix from turns of the encoders and motors to turns of the joints, and its inverse.
  [[nodiscard]] const JointMatrix& gears() const noexcept { return this->gears_; }
  [[nodiscard]] const JointMatrix& ungears() const noexcept { return this->ungears_; }

private:
  [[nodiscard]] std::optional<JointVector> checked(std::optional<JointVector> q) const noexcept;
  [[nodiscard]] JointVector middle() const noexcept;
  void place(Posture& posture) const noexcept;
  [[nodiscard]] Posture ownCarrier(const JointVector& q) const noexcept;
  [[nodiscard]] Posture ownPosture(const JointVector& q) const noexcept;
  [[nodiscard]] LinkPoint ownPoint(const JointVector& q, int link, const Vec3& at) const noexcept;
  [[nodiscard]] std::optional<JointVector> baseFor(const Vec3& p) const noexcept;
  [[nodiscard]] bool aim(const ChainGoal& goal, JointVector& q) const noexcept;
  [[nodiscard]] std::optional<JointVector> step(const ChainGoal& goal, const JointVector& from) const noexcept;
  [[nodiscard]] std::optional<JointVector> searched(const ChainGoal& goal, const JointVector& near) const noexcept;
  [[nodiscard]] bool isSearched() const noexcept; ///< iteratively

  ArmPlan plan_;
  int joints_ = 0, motors_ = 0, directions_ = 3;
  Mat3 turn_D_ = Mat3::Identity(); ///< rotation of the base
  JointMatrix gears_;              ///< q = zero + gears * turns of the encoders
  JointMatrix ungears_;
};

} // namespace palpate
