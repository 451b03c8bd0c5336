// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/arm/SerialArm.h"

#include <cmath>
#include <limits>

#include <Eigen/Cholesky>

#include "haptics/core/PoseMath.h"

namespace palpate
{
namespace
{

/// Positions and axes of the hinges, and the frame of the last link.
struct Chain
{
  std::array<Vec3, mostJoints> hinges, axes;
  Pose link;
};

Chain chainOf(const SerialGeometry& chain, const JointVector& q, int links) noexcept
{
  Chain made;
  for (int k = 0; k < links; ++k)
  {
    const auto i = static_cast<std::size_t>(k);
    const SerialGeometry::Hinge& hinge = chain.hinges[i];
    made.link = made.link * hinge.origin;
    made.hinges[i] = made.link.p;
    made.axes[i] = made.link.q * hinge.axis;
    const double half = 0.5 * q[k];
    const Vec3 sine = std::sin(half) * hinge.axis;
    made.link.q = made.link.q * Quat(std::cos(half), sine.x(), sine.y(), sine.z());
  }
  return made;
}

using Error = Eigen::Matrix<double, 6, 1>;

/// Error from the tip to the goal: the position in rows 0 .. 2 [m], a goal's rotation in rows 3 .. 5 [m at the lever].
Error errorOf(const Pose& tip, const ChainGoal& goal, double lever_m) noexcept
{
  Error error = Error::Zero();
  error.head<3>() = goal.p - tip.p;
  if (goal.turn)
  {
    const Quat left = *goal.turn * tip.q.conjugate();
    error.tail<3>() = 2.0 * lever_m * std::copysign(1.0, left.w()) * left.vec();
  }
  return error;
}

double reachOf(const SerialGeometry& chain) noexcept
{
  double reach = chain.tip.p.norm();
  for (int k = 0; k < chain.count; ++k)
  {
    reach += chain.hinges[static_cast<std::size_t>(k)].origin.p.norm();
  }
  return reach;
}

} // namespace

Posture postureOf(const SerialGeometry& chain, const JointVector& q) noexcept
{
  const Chain made = chainOf(chain, q, chain.count);
  Posture posture;
  posture.exists = true;
  posture.tip = made.link * chain.tip;
  posture.tip.q.normalize();
  posture.jacobian.resize(6, chain.count);
  for (int k = 0; k < chain.count; ++k)
  {
    const auto i = static_cast<std::size_t>(k);
    posture.jacobian.col(k).head<3>() = made.axes[i].cross(posture.tip.p - made.hinges[i]);
    posture.jacobian.col(k).tail<3>() = made.axes[i];
  }
  return posture;
}

LinkPoint linkPointOf(const SerialGeometry& chain, const JointVector& q, int link, const Vec3& at) noexcept
{
  const Chain made = chainOf(chain, q, link);
  LinkPoint point;
  point.p = made.link * at;
  point.jacobian = PointJacobian::Zero(3, chain.count);
  for (int k = 0; k < link; ++k)
  {
    const auto i = static_cast<std::size_t>(k);
    point.jacobian.col(k) = made.axes[i].cross(point.p - made.hinges[i]);
  }
  return point;
}

std::optional<JointVector> stepTo(const SerialGeometry& chain, const ChainGoal& goal, const JointVector& near) noexcept
{
  constexpr int mostSteps = 120;
  const double reach = reachOf(chain);
  JointVector q = near;
  Posture posture = postureOf(chain, q);
  Error error = errorOf(posture.tip, goal, reach);
  double damping = 1e-3;
  for (int step = 0; step < mostSteps && error.norm() > 4.0 * std::numeric_limits<double>::epsilon() * reach; ++step)
  {
    ArmJacobian J = posture.jacobian;
    J.bottomRows<3>() *= goal.turn ? reach : 0.0;
    JointMatrix normal = J.transpose() * J;
    normal.diagonal().array() += damping * reach * reach;
    const JointVector next = q + normal.ldlt().solve(J.transpose() * error);
    const Posture there = postureOf(chain, next);
    const Error left = errorOf(there.tip, goal, reach);
    const bool nearer = left.norm() < error.norm();
    damping *= nearer ? 0.1 : 10.0;
    if (nearer)
    {
      q = next;
      posture = there;
      error = left;
    }
    else if (damping > 1e6)
    {
      break;
    }
    damping = std::max(damping, 1e-15);
  }
  constexpr double rounding = 1e-13;
  return error.norm() <= rounding * reach ? std::optional(q) : std::nullopt;
}

} // namespace palpate
