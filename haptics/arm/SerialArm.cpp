// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/arm/SerialArm.h"

#include <cmath>

#include "haptics/arm/PostureSearch.h"
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

double reachOf(const SerialGeometry& chain) noexcept
{
  double reach = chain.tip.p.norm();
  for (int k = 0; k < chain.count; ++k)
  {
    reach += chain.hinges[static_cast<std::size_t>(k)].origin.p.norm();
  }
  return reach;
}

std::optional<JointVector> stepTo(const SerialGeometry& chain, const ChainGoal& goal, const JointVector& near) noexcept
{
  return stepTo([&chain](const JointVector& q) { return postureOf(chain, q); }, reachOf(chain), goal, near);
}

} // namespace palpate
