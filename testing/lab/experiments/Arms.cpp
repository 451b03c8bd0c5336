// SPDX-License-Identifier: GPL-3.0-or-later
// Row 87: forces and masses that an arm's links make of its motors and masses: maps of two arms of the same links
// beside each other, the stiffest wall of the simulated arms, and a Jacobian that is wrong.
#include <cmath>
#include <string>

#include <Eigen/LU>

#include "devices/simulated/ArmPlant.h"
#include "haptics/arm/ArmDynamics.h"
#include "haptics/arm/ArmMeasures.h"
#include "haptics/arm/file/ArmFile.h"
#include "haptics/force/SampledWall.h"
#include "testing/lab/Experiments.h"
#include "testing/support/Arms.h"
#include "testing/support/CostSample.h"

namespace palpate::lab
{
namespace arms_experiment
{

struct Named
{
  const char* name;
  ArmPlan plan;
  double soft_N_per_m, stiff_N_per_m, condition, leastMass_kg, mostMass_kg, usable_cm2; ///< listed
};

/// Links of 150 mm, the tip at (0, 200) mm: theory, by differences of other formulas.
std::vector<Named> planeArms()
{
  return { { "serial", test::twoLinks(), 188.4, 1061.6, 2.374, .0043, .1095, 1100.0 },
    { "five-bar", test::fiveBar(), 214.5, 677.1, 1.777, .0021, .0068, 826.0 } };
}

void judgePlaneArm(const Named& arm, Table& table)
{
  const Arm made(arm.plan);
  const std::string at = caseName({ { "x_mm", 0 }, { "y_mm", 200 } });
  const ArmMeasures here = measure(made, *made.inverse(Vec3(0.0, 0.2, 0.0)));
  constexpr double joint_Nm_per_rad = 10.0, half = 0.5; // of a last digit that is listed
  const double soft = joint_Nm_per_rad / std::pow(here.singular[0], 2);
  const double stiff = joint_Nm_per_rad / std::pow(here.singular[1], 2);
  table.within({ at, arm.name, "softest stiffness of the tip", "N/m" }, soft, arm.soft_N_per_m, 0.1 * half);
  table.within({ at, arm.name, "stiffest of the tip", "N/m" }, stiff, arm.stiff_N_per_m, 0.1 * half);
  table.within({ at, arm.name, "condition" }, here.condition, arm.condition, 1e-3 * half);
  table.within({ at, arm.name, "least apparent mass", "kg" }, here.leastMass_kg, arm.leastMass_kg, 1e-4 * half);
  table.within({ at, arm.name, "most apparent mass", "kg" }, here.mostMass_kg, arm.mostMass_kg, 1e-4 * half);
}

/// The half plane above the base by squares of `step_m`: a row a place for the map, and the share that can be used.
void mapPlaneArm(const Named& arm, int coarser, Table& table)
{
  const Arm made(arm.plan);
  constexpr double step_m = 0.005;
  int usable = 0;
  for (int x = -60; x <= 60; ++x)
  {
    for (int y = 1; y <= 60; ++y)
    {
      const std::optional<JointVector> q = made.inverse(Vec3(step_m * x, step_m * y, 0.0));
      const ArmMeasures here = q ? measure(made, *q) : ArmMeasures{};
      if (!q || !(here.condition < 5.0))
      {
        continue;
      }
      ++usable;
      if (x % coarser == 0 && y % coarser == 0)
      {
        const std::string at = caseName({ { "x_mm", 5.0 * x }, { "y_mm", 5.0 * y } });
        table.info({ at, arm.name, "condition" }, here.condition);
        table.info({ at, arm.name, "map: softest stiffness", "N/m" }, 10.0 / std::pow(here.singular[0], 2));
        table.info({ at, arm.name, "map: largest force, worst direction", "N" }, here.leastForce_N);
        table.info({ at, arm.name, "map: most apparent mass", "kg" }, here.mostMass_kg);
      }
    }
  }
  const double area_cm2 = 1e4 * step_m * step_m * usable;
  table.within(
    { "half plane", arm.name, "usable, condition below 5", "cm2" }, area_cm2, arm.usable_cm2, 0.01 * arm.usable_cm2);
}

/// Linear: without friction, steps, limits and weight.
ArmPlan linearised(const ArmPlan& plan)
{
  ArmPlan plain = plan;
  plain.gravity_D.setZero();
  plain.maxCondition = 1e6;
  for (ArmJoint& joint : plain.joints)
  {
    joint.friction_Nm = joint.countsPerTurn = joint.torqueStep_Nm = 0.0;
    joint.maxTorque_Nm = std::numeric_limits<double>::infinity();
  }
  return plain;
}

/// Does a small motion against a sampled spring along n grow?
bool growsAt(const ArmPlan& plan, const Vec3& start_D, const Vec3& n_D, double stiffness_N_per_m)
{
  constexpr double period_s = 1e-3, off_m = 1e-6;
  constexpr int ticks = 4000, window = 400;
  ArmPlant plant(plan, HandModel{}, period_s);
  if (!plant.begin(start_D + off_m * n_D, Vec3::Zero()))
  {
    return true;
  }
  double early = 0.0, late = 0.0;
  for (int tick = 0; tick < ticks; ++tick)
  {
    const double away = n_D.dot(plant.position_D() - start_D);
    plant.step(Vec3::Zero(), { -stiffness_N_per_m * away * n_D, Vec3::Zero() });
    early = tick < window ? std::max(early, std::fabs(away)) : early;
    late = tick >= ticks - window ? std::max(late, std::fabs(away)) : late;
    if (std::fabs(away) > 1e-3)
    {
      return true;
    }
  }
  return late > early;
}

/// Along the direction in which the wall shakes first, at a place.
void judgeWall(const std::string& name, const Vec3& aside_D, Table& table)
{
  const ArmPlan plan = linearised(knownArm(name).value);
  const Vec3 place_D = plan.workSpace.centre_D + plan.workSpace.radius_m * aside_D;
  const Arm arm(plan);
  const JointVector q = *arm.inverse(place_D);
  const PrincipalPart part = *principalPartOf(arm, q, arm.posture(q));
  double formula = std::numeric_limits<double>::infinity();
  Vec3 worst = Vec3::Zero();
  for (int i = 0; i < part.count; ++i)
  {
    SampledWall wall;
    wall.mass_kg = part.mass_kg[i];
    wall.damping_Ns_per_m = part.damping_Ns_per_m[i];
    const double critical = criticalStiffness(wall);
    worst = critical < formula ? Vec3(part.directions_D.col(i)) : worst;
    formula = std::min(formula, critical);
  }
  double low = 0.5 * formula, high = 2.0 * formula;
  for (int halving = 0; halving < 10; ++halving)
  {
    const double middle = std::sqrt(low * high);
    (growsAt(plan, place_D, worst, middle) ? high : low) = middle;
  }
  table.within({ caseName({ { "x", aside_D.x() }, { "y", aside_D.y() }, { "z", aside_D.z() } }), name,
                 "stiffest wall in the worst direction", "N/m" },
    std::sqrt(low * high), formula, 0.05 * formula);
}

/// Speeds of the joints over the speed of the tip as libnifalcon has them: sin(theta2)^2 in place of
/// sin(theta2) sin(theta3) in the third column.
Mat3 librarysSpeeds(const DeltaGeometry& delta, const JointVector& q, const Vec3& p, const Mat3& right)
{
  Mat3 wrong = right;
  for (int leg = 0; leg < 3; ++leg)
  {
    // theta3 between the rod and the leg's across axis; theta2 of the rod in the leg's plane.
    const double c = std::cos(delta.legs_rad[static_cast<std::size_t>(leg)]);
    const double s = std::sin(delta.legs_rad[static_cast<std::size_t>(leg)]);
    const double v = -p.x() * s + p.y() * c + delta.offset_m;
    const double sin3 = std::sqrt(1.0 - std::pow(v / delta.forearm_m, 2));
    const double length = delta.forearm_m * sin3 + delta.hinge_m;
    const double sin2 = (p.z() - delta.arm_m * std::sin(q[leg])) / length;
    wrong(leg, 2) *= sin2 / sin3;
  }
  return wrong;
}

/// A host with that matrix gives torques by its inverse transposed; a hand gets their force by the true one.
void judgeWrongJacobian(Table& table)
{
  const ArmPlan plan = knownArm("falcon").value;
  const auto& delta = std::get<DeltaGeometry>(plan.geometry);
  const Arm arm(plan);
  double across = 0.0, rightAcross = 0.0;
  test::Random random(3);
  for (int i = 0; i < 10 * 8; ++i)
  {
    const double turn = 2.0 * M_PI * (i % 8) / 8, radius_m = 0.035;
    const Vec3 p(radius_m * std::cos(turn), radius_m * std::sin(turn), 0.08 + 0.01 * (i / 8));
    const std::optional<JointVector> q = arm.inverse(p);
    if (!q)
    {
      continue;
    }
    const Mat3 J = arm.jacobian(*q).topRows<3>();
    const Mat3 right = J.inverse();
    const Mat3 wrong = librarysSpeeds(delta, *q, p, right);
    for (int direction = 0; direction < 200; ++direction)
    {
      const Vec3 F = random.direction();
      const auto pulled = [&](const Mat3& speeds)
      {
        const Vec3 torque = speeds.inverse().transpose() * F; // of the joints, as a host with that matrix gives it
        const Vec3 felt = right.transpose() * torque;
        return (felt - felt.dot(F) * F).norm();
      };
      across = std::max(across, pulled(wrong));
      rightAcross = std::max(rightAcross, pulled(right));
    }
  }
  table.atMost({ "1 N asked for", "J^T F", "force across", "N" }, rightAcross, 1e-12);
  table.within({ "1 N asked for", "sin(theta2) twice", "force across, at most", "N" }, across, 0.31, 0.02);
}

/// Cost of the kinematics in a tick.
void judgeCost(Table& table)
{
  for (const ArmPlan& plan : test::allArms())
  {
    const Arm arm(plan);
    test::Random random(5);
    const JointVector q = test::randomJoints(arm, random);
    test::CostSample sample(2000);
    double sum = 0.0;
    for (int i = 0; i < 2000; ++i)
    {
      sample.time([&] { sum += arm.torqueOf(q, { Vec3(1, 2, i), Vec3::Zero() }).sum(); });
    }
    table.info({ "posture, Jacobian and torque", plan.name, "sum", "N m" }, sum).cost = Cost::of(sample);
  }
}

} // namespace arms_experiment

void runArms(const Conditions& conditions, Table& table)
{
  using namespace arms_experiment;
  for (const Named& arm : planeArms())
  {
    judgePlaneArm(arm, table);
    mapPlaneArm(arm, conditions.pick(8, 4, 2), table);
  }
  conditions.progress(0.3);
  for (const char* name : { "falcon", "woodenhaptics-2015", "pantograph" })
  {
    judgeWall(name, Vec3::Zero(), table);
    judgeWall(name, Vec3(0.5, -0.5, 0.0), table);
  }
  conditions.progress(0.9);
  judgeWrongJacobian(table);
  judgeCost(table);
}

} // namespace palpate::lab
