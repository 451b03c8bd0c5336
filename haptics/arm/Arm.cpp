// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/arm/Arm.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "haptics/arm/ArmMeasures.h"
#include "haptics/arm/DeltaArm.h"
#include "haptics/arm/FiveBar.h"
#include "haptics/arm/SerialArm.h"
#include "haptics/arm/WoodenArm.h"
#include "haptics/arm/Wrist.h"
#include "haptics/core/PoseMath.h"

namespace palpate
{
namespace
{

/// Fraction of a joint's range and of the largest condition number over which the force fades.
constexpr double fading = 0.05;

double sharePast(double left, double width) noexcept
{
  return std::isinf(left) ? 1.0 : std::clamp(left / width, 0.0, 1.0);
}

} // namespace

Arm::Arm(const ArmPlan& plan)
  : plan_(plan), joints_(jointCountOf(plan.geometry) + plan.wrist.count), directions_(isPlanar(plan.geometry) ? 2 : 3),
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
    turns[k] = perTurn > 0.0 ? wholeTurn_rad * counts[i] / perTurn : 0.0;
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
    const double count = std::floor(encoders_rad[k] / wholeTurn_rad * this->plan_.joints[i].countsPerTurn);
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

/// With the orientation of the link that carries the wrist.
Posture Arm::ownCarrier(const JointVector& q) const noexcept
{
  const JointVector base = q.head(this->joints_ - this->plan_.wrist.count);
  const auto made = [&base](const auto& geometry)
  {
    Posture posture = postureOf(geometry, base);
    // The platform of a delta keeps its orientation.
    if constexpr (requires { turnCarrier(geometry, base, posture); })
    {
      if (posture.exists)
      {
        turnCarrier(geometry, base, posture);
      }
    }
    return posture;
  };
  return std::visit(made, this->plan_.geometry);
}

/// In the frame of the base.
Posture Arm::ownPosture(const JointVector& q) const noexcept
{
  const SerialGeometry& wrist = this->plan_.wrist;
  if (wrist.count == 0)
  {
    return std::visit([&q](const auto& geometry) { return postureOf(geometry, q); }, this->plan_.geometry);
  }
  const Posture carrier = this->ownCarrier(q);
  return carrier.exists ? carried(carrier, wrist, q.tail(wrist.count)) : carrier;
}

void Arm::place(Posture& posture) const noexcept
{
  posture.tip = this->plan_.base_D * posture.tip;
  posture.jacobian.topRows<3>() = (this->turn_D_ * posture.jacobian.topRows<3>()).eval();
  posture.jacobian.bottomRows<3>() = (this->turn_D_ * posture.jacobian.bottomRows<3>()).eval();
}

Posture Arm::posture(const JointVector& q) const noexcept
{
  Posture posture;
  if (q.size() == this->joints_ && q.allFinite())
  {
    posture = this->ownPosture(q);
  }
  if (!posture.exists)
  {
    posture.jacobian = ArmJacobian::Zero(6, this->joints_);
    return posture;
  }
  this->place(posture);
  return posture;
}

Posture Arm::carrier(const JointVector& q) const noexcept
{
  if (this->plan_.wrist.count == 0 || q.size() != this->joints_ || !q.allFinite())
  {
    return this->posture(q);
  }
  Posture carrier = this->ownCarrier(q);
  if (carrier.exists)
  {
    this->place(carrier);
  }
  return carrier;
}

std::optional<Pose> Arm::forward(const JointVector& q) const noexcept
{
  const Posture posture = this->posture(q);
  return posture.exists ? std::optional(posture.tip) : std::nullopt;
}

/// On a link before the wrist, with the joints before it.
LinkPoint Arm::ownPoint(const JointVector& q, int link, const Vec3& at) const noexcept
{
  const PointJacobian none = PointJacobian::Zero(3, q.size());
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
      return posture.exists ? linkPointOf(geometry, q, posture, link, at) : LinkPoint{ Vec3::Zero(), none };
    }
  };
  return std::visit(pointOn, this->plan_.geometry);
}

LinkPoint Arm::linkPoint(const JointVector& q, int link, const Vec3& at) const noexcept
{
  LinkPoint point;
  point.jacobian = PointJacobian::Zero(3, this->joints_);
  if (q.size() != this->joints_ || !q.allFinite())
  {
    return point;
  }
  const int before = linkCountOf(this->plan_.geometry), own = this->plan_.wrist.count;
  if (own == 0)
  {
    point = this->ownPoint(q, link, at);
  }
  else if (link <= before)
  {
    const LinkPoint ofBase = this->ownPoint(q.head(this->joints_ - own), link, at);
    point.p = ofBase.p;
    point.jacobian.leftCols(this->joints_ - own) = ofBase.jacobian;
  }
  else if (const Posture carrier = this->ownCarrier(q); carrier.exists)
  {
    point = carried(carrier, linkPointOf(this->plan_.wrist, q.tail(own), link - before, at));
  }
  point.p = this->plan_.base_D * point.p;
  point.jacobian = (this->turn_D_ * point.jacobian).eval();
  return point;
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
    const double width = fading * (std::isfinite(range) ? range : wholeTurn_rad);
    share = std::min(share, sharePast(std::min(q[k] - joint.low_rad, joint.high_rad - q[k]), width));
  }
  return share;
}

} // namespace palpate
