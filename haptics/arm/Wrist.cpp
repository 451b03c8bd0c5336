// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/arm/Wrist.h"

#include <cmath>

#include "haptics/arm/SerialArm.h"
#include "haptics/core/PoseMath.h"

namespace palpate
{
namespace
{

Quat turnAbout(double angle_rad, const Vec3& axis) noexcept
{
  return Quat(Eigen::AngleAxisd(angle_rad, axis));
}

} // namespace

void turnCarrier(const WoodenGeometry& /*arm*/, const JointVector& q, Posture& posture) noexcept
{
  posture.tip.q = turnAbout(q[0], Vec3::UnitZ()) * turnAbout(-q[2], Vec3::UnitY());
  posture.jacobian.col(0).tail<3>() = Vec3::UnitZ();
  posture.jacobian.col(2).tail<3>() = Vec3(std::sin(q[0]), -std::cos(q[0]), 0.0);
}

void turnCarrier(const FiveBarGeometry& arm, const JointVector& q, Posture& posture) noexcept
{
  const Vec3 fromBase = arm.arm_m * Vec3(std::cos(q[0]), std::sin(q[0]), 0.0); // the arm of joint 1
  const Vec3 forearm = posture.tip.p - (fromBase - 0.5 * arm.base_m * Vec3::UnitX());
  posture.tip.q = turnAbout(std::atan2(forearm.y(), forearm.x()), Vec3::UnitZ());
  for (int k = 0; k < 2; ++k)
  {
    const Vec3 elbow = k == 0 ? Vec3(Vec3::UnitZ().cross(fromBase)) : Vec3(Vec3::Zero());
    const Vec3 way = posture.jacobian.col(k).head<3>() - elbow;
    posture.jacobian.col(k).tail<3>() = forearm.cross(way) / forearm.squaredNorm();
  }
}

LinkPoint carried(const Posture& carrier, const LinkPoint& point) noexcept
{
  const Eigen::Index before = carrier.jacobian.cols(), own = point.jacobian.cols();
  const Mat3 turn = carrier.tip.q.toRotationMatrix();
  const Vec3 way = turn * point.p;
  LinkPoint made;
  made.p = carrier.tip.p + way;
  made.jacobian.resize(3, before + own);
  for (Eigen::Index k = 0; k < before; ++k)
  {
    const Vec3 spin = carrier.jacobian.col(k).tail<3>();
    made.jacobian.col(k) = carrier.jacobian.col(k).head<3>() + spin.cross(way);
  }
  made.jacobian.rightCols(own).noalias() = turn * point.jacobian;
  return made;
}

Posture carried(const Posture& carrier, const SerialGeometry& wrist, const JointVector& q) noexcept
{
  const Posture chain = postureOf(wrist, q);
  const LinkPoint tip = carried(carrier, { chain.tip.p, chain.jacobian.topRows<3>() });
  Posture made;
  made.exists = true;
  made.tip = { tip.p, (carrier.tip.q * chain.tip.q).normalized() };
  made.jacobian.resize(6, tip.jacobian.cols());
  made.jacobian.topRows<3>() = tip.jacobian;
  made.jacobian.bottomRows<3>() << carrier.jacobian.bottomRows<3>(),
    carrier.tip.q.toRotationMatrix() * chain.jacobian.bottomRows<3>();
  return made;
}

SerialGeometry throughOnePoint(const SerialGeometry& wrist) noexcept
{
  SerialGeometry turning = wrist;
  for (SerialGeometry::Hinge& hinge : turning.hinges)
  {
    hinge.origin.p.setZero();
  }
  turning.tip.p.setZero();
  return turning;
}

} // namespace palpate
