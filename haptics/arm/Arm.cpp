// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/arm/Arm.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/LU>

#include "haptics/arm/ArmMeasures.h"
#include "haptics/arm/DeltaArm.h"
#include "haptics/arm/FiveBar.h"
#include "haptics/arm/SerialArm.h"
#include "haptics/arm/WoodenArm.h"
#include "haptics/core/PoseMath.h"

namespace palpate
{
namespace
{

constexpr double turn_rad = 2.0 * std::numbers::pi;
/// Fraction of a joint's range and of the largest condition number over which the force fades.
constexpr double fading = 0.05;

double sharePast(double left, double width) noexcept
{
  return std::isinf(left) ? 1.0 : std::clamp(left / width, 0.0, 1.0);
}

} // namespace

Arm::Arm(const ArmPlan& plan)
  : plan_(plan), joints_(jointCountOf(plan.geometry)), directions_(isPlanar(plan.geometry) ? 2 : 3),
    turn_D_(plan.base_D.q.toRotationMatrix()), gears_(JointMatrix::Zero(this->joints_, this->joints_))
{
  for (int k = 0; k < this->joints_; ++k)
  {
    const ArmJoint& joint = plan.joints[static_cast<std::size_t>(k)];
    this->motors_ += joint.hasMotor ? 1 : 0;
    this->gears_(k, k) = 1.0 / joint.gear;
    if (joint.follows >= 0)
    {
      this->gears_(k, joint.follows) = joint.followShare / plan.joints[static_cast<std::size_t>(joint.follows)].gear;
    }
  }
  this->ungears_ = this->gears_.inverse();
}

JointVector Arm::jointsOfEncoders(const JointVector& encoders_rad) const noexcept
{
  JointVector q = this->gears_ * encoders_rad;
  for (int k = 0; k < this->joints_; ++k)
  {
    q[k] += this->plan_.joints[static_cast<std::size_t>(k)].zero_rad;
  }
  return q;
}

JointVector Arm::jointsOf(const JointCounts& counts) const noexcept
{
  JointVector turns(this->joints_);
  for (int k = 0; k < this->joints_; ++k)
  {
    const auto i = static_cast<std::size_t>(k);
    const double perTurn = this->plan_.joints[i].countsPerTurn;
    turns[k] = perTurn > 0.0 ? turn_rad * counts[i] / perTurn : 0.0;
  }
  return this->jointsOfEncoders(turns);
}

JointCounts Arm::countsOf(const JointVector& q) const noexcept
{
  JointVector turned(this->joints_);
  for (int k = 0; k < this->joints_; ++k)
  {
    turned[k] = q[k] - this->plan_.joints[static_cast<std::size_t>(k)].zero_rad;
  }
  const JointVector encoders_rad = this->ungears_ * turned;
  constexpr double most = 2147483647.0;
  JointCounts counts{};
  for (int k = 0; k < this->joints_; ++k)
  {
    const auto i = static_cast<std::size_t>(k);
    const double count = std::floor(encoders_rad[k] / turn_rad * this->plan_.joints[i].countsPerTurn);
    counts[i] = std::isfinite(count) ? static_cast<std::int32_t>(std::clamp(count, -most, most)) : 0;
  }
  return counts;
}

JointVector Arm::shown(const JointVector& q) const noexcept
{
  const bool counts = std::all_of(this->plan_.joints.begin(), this->plan_.joints.begin() + this->joints_,
    [](const ArmJoint& joint) { return joint.countsPerTurn > 0.0; });
  return counts ? this->jointsOf(this->countsOf(q)) : q;
}

bool Arm::withinLimits(const JointVector& q) const noexcept
{
  for (int k = 0; k < this->joints_; ++k)
  {
    const ArmJoint& joint = this->plan_.joints[static_cast<std::size_t>(k)];
    if (!(q[k] >= joint.low_rad && q[k] <= joint.high_rad))
    {
      return false;
    }
  }
  return true;
}

Posture Arm::posture(const JointVector& q) const noexcept
{
  Posture posture;
  if (q.size() == this->joints_ && q.allFinite())
  {
    posture = std::visit([&q](const auto& geometry) { return postureOf(geometry, q); }, this->plan_.geometry);
  }
  if (!posture.exists)
  {
    posture.jacobian = ArmJacobian::Zero(6, this->joints_);
    return posture;
  }
  posture.tip = this->plan_.base_D * posture.tip;
  posture.jacobian.topRows<3>() = (this->turn_D_ * posture.jacobian.topRows<3>()).eval();
  posture.jacobian.bottomRows<3>() = (this->turn_D_ * posture.jacobian.bottomRows<3>()).eval();
  return posture;
}

std::optional<Pose> Arm::forward(const JointVector& q) const noexcept
{
  const Posture posture = this->posture(q);
  return posture.exists ? std::optional(posture.tip) : std::nullopt;
}

LinkPoint Arm::linkPoint(const JointVector& q, int link, const Vec3& at) const noexcept
{
  LinkPoint point;
  point.jacobian = PointJacobian::Zero(3, this->joints_);
  if (q.size() != this->joints_ || !q.allFinite())
  {
    return point;
  }
  const auto pointOn = [&](const auto& geometry)
  {
    using Geometry = std::decay_t<decltype(geometry)>;
    if constexpr (std::is_same_v<Geometry, SerialGeometry> || std::is_same_v<Geometry, WoodenGeometry>)
    {
      return linkPointOf(geometry, q, link, at);
    }
    else
    {
      const Posture posture = postureOf(geometry, q);
      return posture.exists ? linkPointOf(geometry, q, posture, link, at) : point;
    }
  };
  point = std::visit(pointOn, this->plan_.geometry);
  point.p = this->plan_.base_D * point.p;
  point.jacobian = (this->turn_D_ * point.jacobian).eval();
  return point;
}

JointVector Arm::middle() const noexcept
{
  JointVector q(this->joints_);
  for (int k = 0; k < this->joints_; ++k)
  {
    const ArmJoint& joint = this->plan_.joints[static_cast<std::size_t>(k)];
    const double middle = 0.5 * (joint.low_rad + joint.high_rad);
    q[k] = std::isfinite(middle) ? middle : joint.zero_rad;
  }
  return q;
}

std::optional<JointVector> Arm::checked(std::optional<JointVector> q) const noexcept
{
  for (int k = 0; q && k < this->joints_; ++k)
  {
    // Angles that differ by whole turns are one position: the angle within the limits counts.
    const ArmJoint& joint = this->plan_.joints[static_cast<std::size_t>(k)];
    double& angle = (*q)[k];
    angle += angle > joint.high_rad  ? -turn_rad * std::ceil((angle - joint.high_rad) / turn_rad)
             : angle < joint.low_rad ? turn_rad * std::ceil((joint.low_rad - angle) / turn_rad)
                                     : 0.0;
  }
  return q && q->allFinite() && this->withinLimits(*q) ? q : std::nullopt;
}

std::optional<JointVector> Arm::inverse(const Vec3& p_D) const noexcept
{
  return this->inverse(p_D, this->middle());
}

std::optional<JointVector> Arm::inverse(const Vec3& p_D, const JointVector& near) const noexcept
{
  const Vec3 p = into(this->plan_.base_D, p_D);
  if (!p.allFinite() || (this->directions_ == 2 && std::fabs(p.z()) > 1e-9))
  {
    return std::nullopt;
  }
  if (const auto* const chain = std::get_if<SerialGeometry>(&this->plan_.geometry))
  {
    return this->searched(*chain, { p, std::nullopt }, near);
  }
  const auto solve = [&p](const auto& geometry) -> std::optional<JointVector>
  {
    if constexpr (std::is_same_v<std::decay_t<decltype(geometry)>, SerialGeometry>)
    {
      return std::nullopt;
    }
    else
    {
      return inverseOf(geometry, p);
    }
  };
  const std::optional<JointVector> q = this->checked(std::visit(solve, this->plan_.geometry));
  // Legs that reach p_D may close elsewhere: in the other solution of the forward kinematics.
  const std::optional<Pose> closed = q ? this->forward(*q) : std::nullopt;
  return closed && (closed->p - p_D).norm() <= 1e-9 ? q : std::nullopt;
}

std::optional<JointVector> Arm::inverse(const Pose& tip_D, const JointVector& near) const noexcept
{
  const auto* const chain = std::get_if<SerialGeometry>(&this->plan_.geometry);
  const Pose tip = into(this->plan_.base_D, tip_D);
  return chain != nullptr && tip.p.allFinite() && tip.q.coeffs().allFinite()
           ? this->searched(*chain, { tip.p, tip.q }, near)
           : std::nullopt;
}

/// Searches from `near`, then from points spread over the joints' ranges.
std::optional<JointVector> Arm::searched(
  const SerialGeometry& chain, const ChainGoal& goal, const JointVector& near) const noexcept
{
  constexpr int tries = 24;
  if (near.size() != this->joints_ || !near.allFinite())
  {
    return std::nullopt;
  }
  std::optional<JointVector> found = this->checked(stepTo(chain, goal, near));
  for (int attempt = 1; !found && attempt < tries; ++attempt)
  {
    JointVector from(this->joints_);
    for (int k = 0; k < this->joints_; ++k)
    {
      // Multiples of square roots of primes, less their whole part, are spread evenly (Weyl 1916).
      constexpr std::array<double, mostJoints> roots{ 1.4142135623730951, 1.7320508075688772, 2.23606797749979,
        2.6457513110645907, 3.3166247903554, 3.605551275463989 };
      const double share = std::fmod(attempt * roots[static_cast<std::size_t>(k)], 1.0);
      const ArmJoint& joint = this->plan_.joints[static_cast<std::size_t>(k)];
      const double low = std::max(joint.low_rad, -0.5 * turn_rad), high = std::min(joint.high_rad, 0.5 * turn_rad);
      from[k] = low + share * (high - low);
    }
    found = this->checked(stepTo(chain, goal, from));
  }
  return found;
}

JointVector Arm::torqueOf(const JointVector& q, const Wrench& wrench_D) const noexcept
{
  return this->torqueOf(this->posture(q), wrench_D);
}

JointVector Arm::torqueOf(const Posture& posture, const Wrench& wrench_D) const noexcept
{
  JointVector torque_Nm = posture.jacobian.topRows<3>().transpose() * wrench_D.force +
                          posture.jacobian.bottomRows<3>().transpose() * wrench_D.torque;
  torque_Nm.tail(this->joints_ - this->motors_).setZero();
  return torque_Nm;
}

JointVector Arm::motorTorqueOf(const JointVector& torque_Nm) const noexcept
{
  return this->gears_.transpose() * torque_Nm;
}

double Arm::shareWithinMotors(const JointVector& torque_Nm) const noexcept
{
  const JointVector motors_Nm = this->motorTorqueOf(torque_Nm);
  double share = 1.0;
  for (int k = 0; k < this->motors_; ++k)
  {
    const double most = this->plan_.joints[static_cast<std::size_t>(k)].maxTorque_Nm;
    share = std::fabs(motors_Nm[k]) > most ? std::min(share, most / std::fabs(motors_Nm[k])) : share;
  }
  return share;
}

JointVector Arm::givenTorqueOf(
  const JointVector& q, const Wrench& wrench_D, const JointVector& beside_Nm) const noexcept
{
  return this->givenTorqueOf(q, this->posture(q), wrench_D, beside_Nm);
}

JointVector Arm::givenTorqueOf(
  const JointVector& q, const Posture& posture, const Wrench& wrench_D, const JointVector& beside_Nm) const noexcept
{
  JointVector torque_Nm = this->forceFade(q, posture) * this->torqueOf(posture, wrench_D) + beside_Nm;
  torque_Nm.tail(this->joints_ - this->motors_).setZero();
  return this->shareWithinMotors(torque_Nm) * torque_Nm;
}

double Arm::forceFade(const JointVector& q, const Posture& posture) const noexcept
{
  if (!posture.exists || q.size() != this->joints_)
  {
    return 0.0;
  }
  const double most = this->plan_.maxCondition;
  double share = sharePast(most - conditionOf(*this, posture), fading * most);
  for (int k = 0; k < this->joints_; ++k)
  {
    const ArmJoint& joint = this->plan_.joints[static_cast<std::size_t>(k)];
    const double range = joint.high_rad - joint.low_rad;
    const double width = fading * (std::isfinite(range) ? range : turn_rad);
    share = std::min(share, sharePast(std::min(q[k] - joint.low_rad, joint.high_rad - q[k]), width));
  }
  return share;
}

} // namespace palpate
