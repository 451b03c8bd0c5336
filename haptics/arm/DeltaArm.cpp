// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/arm/DeltaArm.h"

#include <array>
#include <cmath>

#include <Eigen/LU>

#include "haptics/arm/LegPoint.h"
#include "haptics/arm/Triangle.h"

namespace palpate
{
namespace
{

/// A leg in the arm's own frame: the directions of its azimuth and across it, and its elbow, shifted inwards by the
/// platform's size, so that the forearm goes from there to the middle of the platform.
struct Leg
{
  Vec3 out, across;
  double out_m = 0.0, up_m = 0.0; ///< of the elbow, along the azimuth and z
  Vec3 elbow, perRad;             ///< perRad: derivative of the elbow
};

using Legs = std::array<Leg, 3>;

Leg frameOf(const DeltaGeometry& arm, std::size_t i) noexcept
{
  const auto [c, s] = arm.legs[i];
  Leg leg;
  leg.out = { c, s, 0.0 };
  leg.across = { -s, c, 0.0 };
  return leg;
}

Legs legsOf(const DeltaGeometry& arm, const JointVector& q) noexcept
{
  Legs legs;
  for (std::size_t i = 0; i < 3; ++i)
  {
    Leg& leg = legs[i] = frameOf(arm, i);
    const double c = arm.arm_m * std::cos(q[static_cast<Eigen::Index>(i)]);
    const double s = arm.arm_m * std::sin(q[static_cast<Eigen::Index>(i)]);
    leg.out_m = arm.base_m - arm.platform_m + c;
    leg.up_m = arm.side * s;
    leg.elbow = leg.out_m * leg.out - arm.offset_m * leg.across;
    leg.elbow.z() = leg.up_m;
    leg.perRad = -s * leg.out;
    leg.perRad.z() = arm.side * c;
  }
  return legs;
}

/// The point on `side` at the distance `radius_m` from all three elbows.
std::optional<Vec3> meetingOf(const Legs& legs, double radius_m, double side) noexcept
{
  const Vec3 a = legs[1].elbow - legs[0].elbow, b = legs[2].elbow - legs[0].elbow;
  const Vec3 normal = a.cross(b);
  const double area2 = normal.squaredNorm();
  const Vec3 foot = (b.squaredNorm() * normal.cross(a) + a.squaredNorm() * b.cross(normal)) / (2.0 * area2);
  const double high2 = radius_m * radius_m - foot.squaredNorm();
  if (!(area2 > 0.0 && high2 > 0.0))
  {
    return std::nullopt;
  }
  const double high = std::copysign(std::sqrt(high2 / area2), side * normal.z());
  return Vec3(legs[0].elbow + foot + high * normal);
}

/// Error of each forearm's length, as half a difference of squares [m2], and its gradient in a row.
struct Closing
{
  Vec3 left;
  Mat3 rods;
};

/// In the frame of each leg, where its parallelogram has two numbers: this is the innermost loop of every posture.
Closing closingAt(const DeltaGeometry& arm, const Legs& legs, const Vec3& p) noexcept
{
  Closing closing;
  for (int i = 0; i < 3; ++i)
  {
    const Leg& leg = legs[static_cast<std::size_t>(i)];
    const double c = leg.out.x(), s = leg.out.y();
    const double out_m = c * p.x() + s * p.y() - leg.out_m, up_m = p.z() - leg.up_m;
    const double across_m = c * p.y() - s * p.x() + arm.offset_m;
    const double length_m = std::sqrt(out_m * out_m + up_m * up_m);
    const double rod_m = length_m - arm.hinge_m, share = rod_m / length_m; // of the parallelogram
    closing.left[i] = 0.5 * (rod_m * rod_m + across_m * across_m - arm.forearm_m * arm.forearm_m);
    closing.rods.row(i) << share * out_m * c - across_m * s, share * out_m * s + across_m * c, share * up_m;
  }
  return closing;
}

/// Newton's method for the point at which all forearms have their length. Its error is squared in each step, so that
/// after a step of `settled` of the size no more than rounding is left.
std::optional<Vec3> closed(const DeltaGeometry& arm, const Legs& legs, Vec3 p) noexcept
{
  constexpr int mostSteps = 12;
  constexpr double settled = 1e-8;
  const double size = arm.arm_m + arm.forearm_m;
  for (int step = 0; step < mostSteps; ++step)
  {
    const Closing closing = closingAt(arm, legs, p);
    const Vec3 way = closing.rods.inverse() * closing.left;
    if (!(way.norm() < size))
    {
      return std::nullopt;
    }
    p -= way;
    if (way.norm() <= settled * size)
    {
      return p;
    }
  }
  // In a singularity steps shrink slowly and end here; where the lengths are still wrong the arm does not close.
  const Closing closing = closingAt(arm, legs, p);
  return (closing.left.array().abs() <= 1e-13 * size * size).all() ? std::optional(p) : std::nullopt;
}

} // namespace

Posture postureOf(const DeltaGeometry& arm, const JointVector& q) noexcept
{
  Posture posture;
  posture.jacobian = ArmJacobian::Zero(6, 3);
  const Legs legs = legsOf(arm, q);
  const std::optional<Vec3> near = meetingOf(legs, arm.forearm_m + arm.hinge_m, arm.side);
  const std::optional<Vec3> tip = near ? closed(arm, legs, *near) : std::nullopt;
  if (!tip)
  {
    return posture;
  }
  const Mat3 rods = closingAt(arm, legs, *tip).rods;
  // A forearm keeps its length: along the forearm the platform moves as the elbow does.
  const Mat3 follows =
    Vec3(rods.row(0).dot(legs[0].perRad), rods.row(1).dot(legs[1].perRad), rods.row(2).dot(legs[2].perRad))
      .asDiagonal();
  const Mat3 jacobian = rods.inverse() * follows;
  if (!jacobian.allFinite())
  {
    return posture;
  }
  posture.exists = true;
  posture.tip.p = *tip;
  posture.jacobian.topRows<3>() = jacobian;
  return posture;
}

LinkPoint linkPointOf(
  const DeltaGeometry& arm, const JointVector& q, const Posture& posture, int link, const Vec3& at) noexcept
{
  if (link == 7)
  {
    return tipOf(posture);
  }
  const int i = (link - 1) % 3;
  const Leg leg = legsOf(arm, q)[static_cast<std::size_t>(i)];
  LinkPoint elbow, base, end = tipOf(posture);
  // The leg's own elbow, and the end of its forearm on the platform.
  elbow.p = leg.elbow + arm.platform_m * leg.out;
  elbow.jacobian = PointJacobian::Zero(3, 3);
  elbow.jacobian.col(i) = leg.perRad;
  base.p = arm.base_m * leg.out - arm.offset_m * leg.across;
  base.jacobian = PointJacobian::Zero(3, 3);
  end.p += arm.platform_m * leg.out;
  const double forearm_m = arm.forearm_m + arm.hinge_m;
  return link <= 3 ? between(base, elbow, at.x() / arm.arm_m) : between(elbow, end, at.x() / forearm_m);
}

std::optional<JointVector> inverseOf(const DeltaGeometry& arm, const Vec3& p) noexcept
{
  JointVector q(3);
  for (int i = 0; i < 3; ++i)
  {
    const Leg leg = frameOf(arm, static_cast<std::size_t>(i));
    const double out = leg.out.dot(p) + arm.platform_m - arm.base_m, up = arm.side * p.z();
    const double across = leg.across.dot(p) + arm.offset_m;
    const double rod2 = arm.forearm_m * arm.forearm_m - across * across;
    const std::optional<double> aside =
      rod2 > 0.0 ? angleBetween(arm.arm_m, std::hypot(out, up), arm.hinge_m + std::sqrt(rod2)) : std::nullopt;
    if (!aside)
    {
      return std::nullopt;
    }
    q[i] = std::atan2(up, out) - *aside;
  }
  return q;
}

} // namespace palpate
