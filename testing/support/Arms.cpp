// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/support/Arms.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "haptics/arm/ArmMeasures.h"
#include "haptics/arm/file/ArmFile.h"

namespace palpate::test
{
namespace
{

void fitMotors(ArmPlan& plan, double torque_Nm, double rotor_kg_m2)
{
  for (ArmJoint& joint : plan.joints)
  {
    joint.maxTorque_Nm = torque_Nm;
    joint.rotor_kg_m2 = rotor_kg_m2;
  }
}

/// With the elbows as the inverse has them: outwards of a five-bar; above and in front of WoodenHaptics.
bool isUsual(const ArmPlan& plan, const JointVector& q, const Vec3& tip_D)
{
  if (const auto* const bars = std::get_if<FiveBarGeometry>(&plan.geometry))
  {
    const Vec3 tip = tip_D - plan.base_D.p;
    const auto bend = [&](int side)
    {
      const double x = tip.x() + (side == 0 ? 0.5 : -0.5) * bars->base_m;
      return std::cos(q[side]) * tip.y() - std::sin(q[side]) * x;
    };
    return bend(0) < 0.0 && bend(1) > 0.0;
  }
  const auto* const wooden = std::get_if<WoodenGeometry>(&plan.geometry);
  return wooden == nullptr ||
         (std::sin(q[1] + q[2]) > 0.0 && wooden->upper_m * std::sin(q[1]) + wooden->fore_m * std::sin(q[2]) > 0.0);
}

} // namespace

ArmPlan twoLinks()
{
  constexpr double link_m = 0.15;
  SerialGeometry chain;
  chain.count = 2;
  chain.hinges[1].origin.p.x() = link_m;
  chain.tip.p.x() = link_m;
  ArmPlan plan;
  plan.name = "two links";
  plan.geometry = chain;
  plan.masses = { { 0.1, 1, { link_m, 0.0, 0.0 }, { link_m, 0.0, 0.0 } } };
  fitMotors(plan, 10.0, 1e-4);
  // The elbow on one side alone, so that a place has one posture.
  plan.joints[1].low_rad = 0.0;
  plan.joints[1].high_rad = std::numbers::pi;
  return plan;
}

ArmPlan fiveBar()
{
  ArmPlan plan;
  plan.name = "five-bar";
  plan.geometry = FiveBarGeometry{ 0.1, 0.15, 0.15 };
  fitMotors(plan, 10.0, 1e-4);
  return plan;
}

ArmPlan hangingDelta()
{
  DeltaGeometry delta;
  constexpr double third = 2.0 * std::numbers::pi / 3.0;
  using Azimuth = DeltaGeometry::Azimuth;
  delta.legs = { Azimuth::of(0.0), Azimuth::of(third), Azimuth::of(2.0 * third) };
  delta.base_m = 0.1;
  delta.platform_m = 0.04;
  delta.arm_m = 0.15;
  delta.forearm_m = 0.25;
  delta.side = -1.0;
  ArmPlan plan;
  plan.name = "hanging delta";
  plan.geometry = delta;
  fitMotors(plan, 10.0, 1e-4);
  for (int leg = 1; leg <= 3; ++leg)
  {
    plan.masses.push_back({ 0.05, leg, Vec3::Zero(), { 0.15, 0.0, 0.0 } });
    plan.masses.push_back({ 0.03, 3 + leg, Vec3::Zero(), { 0.25, 0.0, 0.0 } });
    // Arms not beyond their upright: there the platform would hang from the other side of the elbows.
    plan.joints[static_cast<std::size_t>(leg - 1)].low_rad = -0.8;
    plan.joints[static_cast<std::size_t>(leg - 1)].high_rad = 1.6;
  }
  plan.masses.push_back({ 0.1, 7, Vec3::Zero(), Vec3::Zero() });
  return plan;
}

ArmPlan sixJoints()
{
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  SerialGeometry chain;
  chain.count = 6;
  const std::array<Vec3, 6> places{ Vec3(0, 0, 0.090), Vec3(0, 0, 0.040), Vec3(-0.135, 0, 0), Vec3(0, 0, -0.080),
    Vec3(0, 0, -0.055), Vec3(0, 0, 0) };
  const std::array<Vec3, 6> axes{ z, y, y, z, y, x };
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    chain.hinges[k].origin.p = places[k];
    chain.hinges[k].axis = axes[k];
  }
  ArmPlan plan;
  plan.name = "six joints";
  plan.geometry = chain;
  plan.base_D = { Vec3(0.1, -0.2, 0.3), Quat(0.5, 0.5, -0.5, 0.5) };
  fitMotors(plan, 10.0, 1e-4);
  plan.masses = { { 0.1, 2, Vec3::Zero(), { -0.135, 0, 0 } }, { 0.05, 3, Vec3::Zero(), { 0, 0, -0.135 } } };
  for (ArmJoint& joint : plan.joints)
  {
    joint.low_rad = -1.2;
    joint.high_rad = 1.2;
  }
  return plan;
}

namespace
{

/// Hinges about these axes, each `apart_m` along z from the one before, and the tip off all of them.
SerialGeometry wristOf(const std::vector<Vec3>& axes, double apart_m, const Vec3& tip)
{
  SerialGeometry wrist;
  for (const Vec3& axis : axes)
  {
    SerialGeometry::Hinge& hinge = wrist.hinges[static_cast<std::size_t>(wrist.count++)];
    hinge.origin.p.z() = apart_m;
    hinge.axis = axis;
  }
  wrist.tip.p = tip;
  return wrist;
}

/// Joints that are sensed alone, and a rod on each link.
ArmPlan withWrist(ArmPlan plan, const std::string& name, const SerialGeometry& wrist)
{
  plan.name = name;
  plan.wrist = wrist;
  for (int k = 0; k < wrist.count; ++k)
  {
    ArmJoint& joint = plan.joints[static_cast<std::size_t>(jointCountOf(plan.geometry) + k)];
    joint = {};
    joint.hasMotor = false;
    joint.low_rad = -1.2;
    joint.high_rad = 1.3;
    plan.masses.push_back({ 0.02, linkCountOf(plan.geometry) + k + 1, { 0.0, 0.01, 0.0 }, { 0.02, -0.01, 0.03 } });
  }
  return plan;
}

} // namespace

std::vector<ArmPlan> armsWithWrists()
{
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  ArmPlan wooden = knownArm("woodenhaptics-2015").value;
  for (ArmJoint& joint : wooden.joints)
  {
    joint.countsPerTurn = 0.0; // as those of the wrist
  }
  ArmPlan turning = withWrist(fiveBar(), "five-bar with a turning handle", wristOf({ z }, 0.0, { 0.03, 0.01, 0.0 }));
  turning.joints[2].hasMotor = true;
  turning.joints[2].rotor_kg_m2 = 1e-6;
  turning.joints[2].maxTorque_Nm = 0.1;
  ArmPlan placed =
    withWrist(hangingDelta(), "delta with a wrist off its centre", wristOf({ z, y, x }, 0.01, { 0.02, -0.03, 0.04 }));
  placed.base_D = { Vec3(0.1, -0.2, 0.3), Quat(0.5, 0.5, -0.5, 0.5) };
  return { placed, withWrist(hangingDelta(), "delta with a tilting plate", wristOf({ x, y }, 0.0, { 0.0, 0.0, 0.05 })),
    withWrist(wooden, "woodenhaptics with a gimbal", wristOf({ z, x, y }, 0.0, Vec3::Zero())),
    withWrist(wooden, "woodenhaptics with a stylus", wristOf({ z, x, y }, 0.005, { 0.0, 0.02, 0.03 })), turning,
    withWrist(fiveBar(), "five-bar with a tilting handle", wristOf({ z, x }, 0.0, { 0.0, 0.03, 0.02 })) };
}

std::vector<UsablePlace> usablePlaces(const Arm& arm, double step_m)
{
  constexpr double reach_m = 0.3; // of the two arms
  const int steps = static_cast<int>(std::lround(reach_m / step_m));
  std::vector<UsablePlace> places;
  for (int x = -steps; x <= steps; ++x)
  {
    for (int y = 1; y <= steps; ++y)
    {
      const Vec3 tip(step_m * x, step_m * y, 0.0);
      const std::optional<JointVector> q = arm.inverse(tip);
      const bool closes = q && (arm.forward(*q)->p - tip).norm() < 1e-9;
      const ArmMeasures at = closes ? measure(arm, *q) : ArmMeasures{};
      if (closes && at.condition < largestUsable)
      {
        places.push_back({ x, y, at });
      }
    }
  }
  return places;
}

std::vector<ArmPlan> allArms()
{
  std::vector<ArmPlan> arms{ twoLinks(), fiveBar(), hangingDelta(), sixJoints() };
  for (const ArmPlan& arm : armsWithWrists())
  {
    arms.push_back(arm);
  }
  for (const std::string& name : knownArms())
  {
    const Outcome<ArmPlan> known = knownArm(name);
    if (!known.ok())
    {
      throw std::runtime_error(name + ": " + known.problem);
    }
    arms.push_back(known.value);
  }
  return arms;
}

/// A rod is as high as the middle of its ends.
double heightEnergyOf(const Arm& arm, const JointVector& q)
{
  double energy = 0.0;
  for (const ArmMass& mass : arm.plan().masses)
  {
    const Vec3 middle = 0.5 * (arm.linkPoint(q, mass.link, mass.from).p + arm.linkPoint(q, mass.link, mass.to).p);
    energy -= mass.mass_kg * arm.plan().gravity_D.dot(middle);
  }
  return energy;
}

JointVector randomJoints(const Arm& arm, Random& random)
{
  for (;;)
  {
    JointVector q(arm.joints());
    for (int k = 0; k < arm.joints(); ++k)
    {
      const ArmJoint& joint = arm.plan().joints[static_cast<std::size_t>(k)];
      q[k] = random.uniform(std::max(joint.low_rad, -std::numbers::pi), std::min(joint.high_rad, std::numbers::pi));
    }
    const Posture posture = arm.posture(q);
    if (posture.exists && isUsual(arm.plan(), q, arm.carrier(q).tip.p) &&
        conditionOf(arm, posture) < arm.plan().maxCondition)
    {
      return q;
    }
  }
}

} // namespace palpate::test
