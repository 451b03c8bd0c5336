// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/arm/ArmDynamics.h"

namespace palpate
{
namespace
{

/// Calls visit(mass, point) for points that move as the masses do.
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

double heightEnergyOf(const Arm& arm, const JointVector& q) noexcept
{
  double energy = 0.0;
  forEachPoint(
    arm, q, [&](double mass_kg, const LinkPoint& point) { energy -= mass_kg * arm.plan().gravity_D.dot(point.p); });
  return energy;
}

} // namespace palpate
