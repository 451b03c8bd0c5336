// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/arm/FiveBar.h"

#include <array>
#include <cmath>

#include <Eigen/LU>

#include "haptics/arm/LegPoint.h"
#include "haptics/arm/Triangle.h"

namespace palpate
{
namespace
{

using Vec2 = Eigen::Vector2d;

struct Elbow
{
  Vec2 p, perRad;
};

double baseOf(const FiveBarGeometry& arm, int side) noexcept
{
  return (side == 0 ? -0.5 : 0.5) * arm.base_m;
}

Elbow elbowOf(const FiveBarGeometry& arm, const JointVector& q, int side) noexcept
{
  const Vec2 along = arm.arm_m * Vec2(std::cos(q[side]), std::sin(q[side]));
  return { Vec2(baseOf(arm, side), 0.0) + along, Vec2(-along.y(), along.x()) };
}

} // namespace

Posture postureOf(const FiveBarGeometry& arm, const JointVector& q) noexcept
{
  const std::array<Elbow, 2> elbows{ elbowOf(arm, q, 0), elbowOf(arm, q, 1) };
  const Vec2 half = 0.5 * (elbows[1].p - elbows[0].p);
  const double high2 = arm.forearm_m * arm.forearm_m - half.squaredNorm();
  Posture posture;
  posture.jacobian = ArmJacobian::Zero(6, 2);
  if (!(high2 > 0.0 && half.squaredNorm() > 0.0))
  {
    return posture;
  }
  posture.exists = true;
  const Vec2 tip = 0.5 * (elbows[0].p + elbows[1].p) + std::sqrt(high2) * Vec2(-half.y(), half.x()).normalized();
  posture.tip.p = { tip.x(), tip.y(), 0.0 };
  // A forearm keeps its length: along the forearm the tip moves as the elbow does.
  Eigen::Matrix2d forearms;
  forearms << (tip - elbows[0].p).transpose(), (tip - elbows[1].p).transpose();
  const Vec2 follows(forearms.row(0).dot(elbows[0].perRad), forearms.row(1).dot(elbows[1].perRad));
  posture.jacobian.topRows<2>() = forearms.inverse() * follows.asDiagonal();
  return posture;
}

LinkPoint linkPointOf(
  const FiveBarGeometry& arm, const JointVector& q, const Posture& posture, int link, const Vec3& at) noexcept
{
  const int side = (link - 1) % 2;
  const Elbow elbow = elbowOf(arm, q, side);
  LinkPoint end;
  end.p = { elbow.p.x(), elbow.p.y(), 0.0 };
  end.jacobian = PointJacobian::Zero(3, 2);
  end.jacobian.col(side).head<2>() = elbow.perRad;
  LinkPoint begin;
  begin.p.x() = baseOf(arm, side);
  begin.jacobian = PointJacobian::Zero(3, 2);
  return link <= 2 ? between(begin, end, at.x() / arm.arm_m) : between(end, tipOf(posture), at.x() / arm.forearm_m);
}

std::optional<JointVector> inverseOf(const FiveBarGeometry& arm, const Vec3& p) noexcept
{
  JointVector q(2);
  for (int side = 0; side < 2; ++side)
  {
    const Vec2 way(p.x() - baseOf(arm, side), p.y());
    const std::optional<double> aside = angleBetween(arm.arm_m, way.norm(), arm.forearm_m);
    if (!aside)
    {
      return std::nullopt;
    }
    q[side] = std::atan2(way.y(), way.x()) + (side == 0 ? *aside : -*aside);
  }
  return q;
}

} // namespace palpate
