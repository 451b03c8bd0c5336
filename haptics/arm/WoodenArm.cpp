// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/arm/WoodenArm.h"

#include <cmath>

#include "haptics/arm/Triangle.h"

namespace palpate
{
namespace
{

/// The point that is `upper_m` along the upper link and `fore_m` along a forearm from there.
LinkPoint pointAt(const WoodenGeometry& arm, const JointVector& q, double upper_m, double fore_m) noexcept
{
  const double cosA = std::cos(q[0]), sinA = std::sin(q[0]);
  const double outB = upper_m * std::sin(q[1]), upB = upper_m * std::cos(q[1]);
  const double outC = fore_m * std::sin(q[2]), upC = fore_m * std::cos(q[2]);
  LinkPoint point;
  point.p = { cosA * (outB + outC), sinA * (outB + outC), arm.column_m + upB - upC };
  point.jacobian.resize(3, 3);
  point.jacobian.col(0) = Vec3(-sinA, cosA, 0.0) * (outB + outC);
  point.jacobian.col(1) = Vec3(cosA * upB, sinA * upB, -outB);
  point.jacobian.col(2) = Vec3(cosA * upC, sinA * upC, outC);
  return point;
}

} // namespace

Posture postureOf(const WoodenGeometry& arm, const JointVector& q) noexcept
{
  const LinkPoint tip = pointAt(arm, q, arm.upper_m, arm.fore_m);
  Posture posture;
  posture.exists = true;
  posture.tip.p = tip.p;
  posture.jacobian = ArmJacobian::Zero(6, 3);
  posture.jacobian.topRows<3>() = tip.jacobian;
  return posture;
}

LinkPoint linkPointOf(const WoodenGeometry& arm, const JointVector& q, int link, const Vec3& at) noexcept
{
  return link == 1 ? pointAt(arm, q, at.x(), 0.0) : pointAt(arm, q, arm.upper_m, at.x());
}

std::optional<JointVector> inverseOf(const WoodenGeometry& arm, const Vec3& p) noexcept
{
  const double out = std::hypot(p.x(), p.y()), up = p.z() - arm.column_m;
  const std::optional<double> shoulder = angleBetween(arm.upper_m, std::hypot(out, up), arm.fore_m);
  if (!shoulder)
  {
    return std::nullopt;
  }
  JointVector q(3);
  q[0] = std::atan2(p.y(), p.x());
  q[1] = std::atan2(out, up) - *shoulder;
  q[2] = std::atan2(out - arm.upper_m * std::sin(q[1]), arm.upper_m * std::cos(q[1]) - up);
  return q;
}

} // namespace palpate
