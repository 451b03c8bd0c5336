// SPDX-License-Identifier: GPL-3.0-or-later
// Joints for a place or a pose of the tip.
#include <algorithm>
#include <cmath>

#include "haptics/arm/Arm.h"
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

/// The length of all links together, about [m].
double sizeOf(const SerialGeometry& chain) noexcept
{
  return reachOf(chain);
}
double sizeOf(const WoodenGeometry& arm) noexcept
{
  return arm.column_m + arm.upper_m + arm.fore_m;
}
double sizeOf(const DeltaGeometry& arm) noexcept
{
  return arm.base_m + arm.arm_m + arm.forearm_m + arm.hinge_m;
}
double sizeOf(const FiveBarGeometry& arm) noexcept
{
  return arm.base_m + arm.arm_m + arm.forearm_m;
}

} // namespace

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
    angle += angle > joint.high_rad  ? -wholeTurn_rad * std::ceil((angle - joint.high_rad) / wholeTurn_rad)
             : angle < joint.low_rad ? wholeTurn_rad * std::ceil((joint.low_rad - angle) / wholeTurn_rad)
                                     : 0.0;
  }
  return q && q->allFinite() && this->withinLimits(*q) ? q : std::nullopt;
}

std::optional<JointVector> Arm::inverse(const Vec3& p_D) const noexcept
{
  return this->inverse(p_D, this->middle());
}

/// The joints before a wrist that bring the tip of its kind to a place; nothing for a chain.
std::optional<JointVector> Arm::baseFor(const Vec3& p) const noexcept
{
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
  return std::visit(solve, this->plan_.geometry);
}

bool Arm::isSearched() const noexcept
{
  return this->plan_.wrist.count > 0 || std::holds_alternative<SerialGeometry>(this->plan_.geometry);
}

std::optional<JointVector> Arm::inverse(const Vec3& p_D, const JointVector& near) const noexcept
{
  const Vec3 p = into(this->plan_.base_D, p_D);
  const bool isPlane = this->directions_ == 2 && this->plan_.wrist.count == 0;
  if (!p.allFinite() || (isPlane && std::fabs(p.z()) > 1e-9))
  {
    return std::nullopt;
  }
  if (this->isSearched())
  {
    return this->searched({ p, std::nullopt }, near);
  }
  const std::optional<JointVector> q = this->checked(this->baseFor(p));
  // Legs that reach p_D may close elsewhere: in the other solution of the forward kinematics.
  const std::optional<Pose> closed = q ? this->forward(*q) : std::nullopt;
  return closed && (closed->p - p_D).norm() <= 1e-9 ? q : std::nullopt;
}

std::optional<JointVector> Arm::inverse(const Pose& tip_D, const JointVector& near) const noexcept
{
  const Pose tip = into(this->plan_.base_D, tip_D);
  return this->isSearched() && tip.p.allFinite() && tip.q.coeffs().allFinite() ? this->searched({ tip.p, tip.q }, near)
                                                                               : std::nullopt;
}

/// Moves the base so that the tip would be at the goal if the wrist kept its place, then turns the wrist. With all
/// hinges and the tip at one point that is the solution. False: no joints of the base reach there.
bool Arm::aim(const ChainGoal& goal, JointVector& q) const noexcept
{
  const int own = this->plan_.wrist.count;
  const Posture carrier = this->ownCarrier(q), tip = this->ownPosture(q);
  const Vec3 way = carrier.exists ? Vec3(tip.tip.p - carrier.tip.p) : Vec3(Vec3::Zero());
  const std::optional<JointVector> base = this->baseFor(goal.p - way);
  if (!base)
  {
    return false;
  }
  q.head(this->joints_ - own) = *base;
  const Posture there = this->ownCarrier(q);
  if (goal.turn && there.exists)
  {
    constexpr double lever_m = 1.0; // the rotation alone counts
    const ChainGoal turn{ Vec3::Zero(), there.tip.q.conjugate() * *goal.turn };
    const SerialGeometry turning = throughOnePoint(this->plan_.wrist);
    const auto postureAt = [&turning](const JointVector& wrist) { return postureOf(turning, wrist); };
    if (const std::optional<JointVector> turned = stepTo(postureAt, lever_m, turn, q.tail(own)))
    {
      q.tail(own) = *turned;
    }
  }
  return true;
}

/// The joints for a goal that are found from there. A wrist through one point is aimed first, and that is the solution.
/// Any other one moves the tip where it turns: all joints move at once from there, and then from where two aims lead.
std::optional<JointVector> Arm::step(const ChainGoal& goal, const JointVector& from) const noexcept
{
  if (const auto* const chain = std::get_if<SerialGeometry>(&this->plan_.geometry))
  {
    return stepTo(*chain, goal, from);
  }
  const double wrist_m = reachOf(this->plan_.wrist);
  const double size_m = std::visit([](const auto& geometry) { return sizeOf(geometry); }, this->plan_.geometry);
  const auto all = [&](const JointVector& q)
  { return stepTo([this](const JointVector& at) { return this->ownPosture(at); }, size_m + wrist_m, goal, q); };
  const std::optional<JointVector> near = wrist_m > 0.0 ? all(from) : std::nullopt;
  JointVector q = from;
  return near ? near : this->aim(goal, q) && this->aim(goal, q) ? all(q) : std::nullopt;
}

/// Searches from `near`, then from points spread over the joints' ranges.
std::optional<JointVector> Arm::searched(const ChainGoal& goal, const JointVector& near) const noexcept
{
  constexpr int tries = 24;
  if (near.size() != this->joints_ || !near.allFinite())
  {
    return std::nullopt;
  }
  std::optional<JointVector> found = this->checked(this->step(goal, near));
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
      const double low = std::max(joint.low_rad, -0.5 * wholeTurn_rad),
                   high = std::min(joint.high_rad, 0.5 * wholeTurn_rad);
      from[k] = low + share * (high - low);
    }
    found = this->checked(this->step(goal, from));
  }
  return found;
}

} // namespace palpate
