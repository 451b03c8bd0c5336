// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/oracles/arm/ArmOracle.h"

#include <Eigen/LU>

namespace palpate::test
{
namespace
{

using QuadMatrix = Eigen::Matrix<Quad, 3, 3>;

QuadPoint inQuad(const Vec3& p)
{
  return p.cast<Quad>();
}

QuadMatrix turnOf(const Quat& rounded)
{
  const Eigen::Quaternion<Quad> q = rounded.cast<Quad>().normalized();
  return q.toRotationMatrix();
}

QuadMatrix turnAbout(const Vec3& axis, const Quad& angle)
{
  const QuadPoint n = inQuad(axis).normalized();
  QuadMatrix cross;
  cross << Quad(0), -n.z(), n.y(), n.z(), Quad(0), -n.x(), -n.y(), n.x(), Quad(0);
  return QuadMatrix::Identity() + sin(angle) * cross + (Quad(1) - cos(angle)) * cross * cross;
}

QuadPoint tipOf(const SerialGeometry& chain, const QuadVector& q, const Vec3& /*near*/)
{
  // The point is taken from the tip to the base, without a frame.
  QuadPoint p = inQuad(chain.tip.p);
  for (int k = chain.count - 1; k >= 0; --k)
  {
    const SerialGeometry::Hinge& hinge = chain.hinges[static_cast<std::size_t>(k)];
    p = inQuad(hinge.origin.p) + turnOf(hinge.origin.q) * (turnAbout(hinge.axis, q[k]) * p);
  }
  return p;
}

QuadPoint tipOf(const WoodenGeometry& arm, const QuadVector& q, const Vec3& /*near*/)
{
  const Quad out = Quad(arm.upper_m) * sin(q[1]) + Quad(arm.fore_m) * sin(q[2]);
  return { out * cos(q[0]), out * sin(q[0]),
    Quad(arm.column_m) + Quad(arm.upper_m) * cos(q[1]) - Quad(arm.fore_m) * cos(q[2]) };
}

/// Newton's method for left(p) = 0, with slopes by central differences.
template<class Left>
QuadPoint solve(const Left& left, QuadPoint p)
{
  const Quad h("1e-17");
  for (int step = 0; step < 4; ++step)
  {
    QuadMatrix slope;
    for (int k = 0; k < 3; ++k)
    {
      QuadPoint high = p, low = p;
      high[k] += h;
      low[k] -= h;
      slope.col(k) = (left(high) - left(low)) / (Quad(2) * h);
    }
    p -= slope.fullPivLu().solve(left(p)).eval();
  }
  return p;
}

QuadPoint tipOf(const DeltaGeometry& arm, const QuadVector& q, const Vec3& near)
{
  // Each leg ends at its own joints on the platform, where the distance of the hinges takes hinge_m from its rod.
  const auto left = [&](const QuadPoint& p)
  {
    QuadPoint all;
    for (int i = 0; i < 3; ++i)
    {
      const auto [cosine, sine] = arm.legs[static_cast<std::size_t>(i)];
      const Quad c = cosine, s = sine;
      const Quad out = p.x() * c + p.y() * s + Quad(arm.platform_m) - Quad(arm.base_m) - Quad(arm.arm_m) * cos(q[i]);
      const Quad across = -p.x() * s + p.y() * c + Quad(arm.offset_m);
      const Quad up = p.z() - Quad(arm.side) * Quad(arm.arm_m) * sin(q[i]);
      const Quad rod = sqrt(Quad(arm.forearm_m) * Quad(arm.forearm_m) - across * across);
      all[i] = sqrt(out * out + up * up) - Quad(arm.hinge_m) - rod;
    }
    return all;
  };
  return solve(left, inQuad(near));
}

QuadPoint tipOf(const FiveBarGeometry& arm, const QuadVector& q, const Vec3& near)
{
  const auto left = [&](const QuadPoint& p)
  {
    QuadPoint all;
    for (int i = 0; i < 2; ++i)
    {
      const Quad base = Quad(i == 0 ? -1 : 1) * Quad(arm.base_m) / Quad(2);
      const Quad x = p.x() - base - Quad(arm.arm_m) * cos(q[i]), y = p.y() - Quad(arm.arm_m) * sin(q[i]);
      all[i] = sqrt(x * x + y * y) - Quad(arm.forearm_m);
    }
    all[2] = p.z();
    return all;
  };
  return solve(left, inQuad(near));
}

QuadMatrix axesOf(const QuadPoint& x, const QuadPoint& y, const QuadPoint& z)
{
  QuadMatrix axes;
  axes << x, y, z;
  return axes;
}

/// Axes of the link that carries a wrist, from the directions of links. `tip`: its end.
QuadMatrix carrierOf(const DeltaGeometry& /*arm*/, const QuadVector& /*q*/, const QuadPoint& /*tip*/)
{
  return QuadMatrix::Identity();
}

QuadMatrix carrierOf(const WoodenGeometry& arm, const QuadVector& q, const QuadPoint& tip)
{
  const Quad out = Quad(arm.upper_m) * sin(q[1]);
  const QuadPoint elbow(out * cos(q[0]), out * sin(q[0]), Quad(arm.column_m) + Quad(arm.upper_m) * cos(q[1]));
  const QuadPoint across(-sin(q[0]), cos(q[0]), Quad(0));
  const QuadPoint back = (elbow - tip) / Quad(arm.fore_m);
  return axesOf(across.cross(back), across, back);
}

QuadMatrix carrierOf(const FiveBarGeometry& arm, const QuadVector& q, const QuadPoint& tip)
{
  const QuadPoint elbow(Quad(arm.arm_m) * cos(q[0]) - Quad(arm.base_m) / Quad(2), Quad(arm.arm_m) * sin(q[0]), Quad(0));
  const QuadPoint along = (tip - elbow) / Quad(arm.forearm_m), up(Quad(0), Quad(0), Quad(1));
  return axesOf(along, up.cross(along), up);
}

QuadMatrix carrierOf(const SerialGeometry& /*chain*/, const QuadVector& /*q*/, const QuadPoint& /*tip*/)
{
  return QuadMatrix::Identity(); // a chain carries no wrist
}

} // namespace

QuadPoint tipInQuad(const ArmPlan& plan, const QuadVector& q, const Vec3& near_D)
{
  const QuadMatrix turn = turnOf(plan.base_D.q);
  const QuadPoint near = turn.transpose() * (inQuad(near_D) - inQuad(plan.base_D.p));
  const QuadVector base = q.head(jointCountOf(plan.geometry)), own = q.tail(plan.wrist.count);
  const auto carriedTip = [&](const auto& geometry)
  {
    const QuadPoint tip = tipOf(geometry, base, near.cast<double>());
    return QuadPoint(tip + carrierOf(geometry, base, tip) * tipOf(plan.wrist, own, Vec3::Zero()));
  };
  return inQuad(plan.base_D.p) + turn * std::visit(carriedTip, plan.geometry);
}

Vec3 tipSlope(const ArmPlan& plan, const JointVector& q, const JointVector& way, const Vec3& near_D)
{
  const Quad h("1e-10");
  const QuadVector at = q.cast<Quad>(), along = way.cast<Quad>();
  const QuadPoint high = tipInQuad(plan, at + h * along, near_D), low = tipInQuad(plan, at - h * along, near_D);
  return ((high - low) / (Quad(2) * h)).cast<double>();
}

} // namespace palpate::test
