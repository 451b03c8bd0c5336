// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/arm/ArmDynamics.h"

#include <cmath>

namespace palpate
{
namespace
{

/// Calls visit(mass, point) for the points that stand for the masses.
template<class Visit>
void forEachPoint(const Arm& arm, const JointVector& q, const Visit& visit) noexcept
{
  for (const ArmMass& mass : arm.plan().masses)
  {
    if (mass.from == mass.to)
    {
      visit(mass.mass_kg, arm.linkPoint(q, mass.link, mass.from));
      continue;
    }
    visit(mass.mass_kg / 6.0, arm.linkPoint(q, mass.link, mass.from));
    visit(mass.mass_kg / 1.5, arm.linkPoint(q, mass.link, 0.5 * (mass.from + mass.to)));
    visit(mass.mass_kg / 6.0, arm.linkPoint(q, mass.link, mass.to));
  }
}

} // namespace

JointMatrix inertiaOf(const Arm& arm, const JointVector& q) noexcept
{
  JointMatrix inertia = JointMatrix::Zero(arm.joints(), arm.joints());
  forEachPoint(arm, q,
    [&](double mass_kg, const LinkPoint& point)
    { inertia.noalias() += mass_kg * (point.jacobian.transpose() * point.jacobian); });
  const JointMatrix& motorTurns = arm.ungears();
  for (int k = 0; k < arm.joints(); ++k)
  {
    const double rotor = arm.plan().joints[static_cast<std::size_t>(k)].rotor_kg_m2;
    inertia.noalias() += rotor * (motorTurns.row(k).transpose() * motorTurns.row(k));
  }
  return inertia;
}

JointVector gravityTorqueOf(const Arm& arm, const JointVector& q) noexcept
{
  JointVector torque = JointVector::Zero(arm.joints());
  forEachPoint(arm, q,
    [&](double mass_kg, const LinkPoint& point)
    { torque += mass_kg * (point.jacobian.transpose() * arm.plan().gravity_D); });
  return torque;
}

JointVector velocityTorqueOf(const Arm& arm, const JointVector& q, const JointVector& rate) noexcept
{
  constexpr double h = 1e-5;
  JointVector torque = JointVector::Zero(arm.joints());
  for (int k = 0; k < arm.joints(); ++k)
  {
    JointVector high = q, low = q;
    high[k] += h;
    low[k] -= h;
    const JointMatrix slope = (inertiaOf(arm, high) - inertiaOf(arm, low)) / (2.0 * h);
    torque.noalias() -= rate[k] * (slope * rate);
    torque[k] += 0.5 * rate.dot(slope * rate);
  }
  return torque;
}

JointVector motorCommandOf(const Arm& arm, const JointVector& shown, const Wrench& wrench_D) noexcept
{
  JointVector motors = arm.motorTorqueOf(arm.givenTorqueOf(shown, wrench_D, -gravityTorqueOf(arm, shown)));
  for (int k = 0; k < arm.motors(); ++k)
  {
    const double step = arm.plan().joints[static_cast<std::size_t>(k)].torqueStep_Nm;
    motors[k] = step > 0.0 ? step * std::round(motors[k] / step) : motors[k];
  }
  return motors;
}

} // namespace palpate
