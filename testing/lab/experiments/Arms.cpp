// SPDX-License-Identifier: GPL-3.0-or-later
// Row 87: forces and masses that an arm's links make of its motors and masses: maps of two arms of the same links
// beside each other, the stiffest wall of the simulated arms, and a Jacobian that is wrong.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <Eigen/LU>

#include "devices/simulated/ArmPlant.h"
#include "devices/simulated/DeviceModels.h"
#include "haptics/arm/ArmDynamics.h"
#include "haptics/arm/ArmMeasures.h"
#include "haptics/arm/file/ArmFile.h"
#include "haptics/force/SampledWall.h"
#include "haptics/force/StabilityLimits.h"
#include "testing/lab/Experiments.h"
#include "testing/support/Arms.h"

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

struct Quality
{
  const char* name;
  const char* unit;
  double (*of)(const ArmMeasures& at);
};

/// With springs of 10 N m/rad and motors of 10 N m in the joints.
constexpr std::array<Quality, 4> qualities{ { { "condition", "", [](const ArmMeasures& at) { return at.condition; } },
  { "softest stiffness", "N/m", [](const ArmMeasures& at) { return 10.0 / std::pow(at.singular[0], 2); } },
  { "largest force in the worst direction", "N", [](const ArmMeasures& at) { return at.leastForce_N; } },
  { "apparent mass in the heaviest direction", "kg", [](const ArmMeasures& at) { return at.mostMass_kg; } } } };

/// Between the directions at one place.
constexpr Quality massEvenness{ "heaviest over lightest direction", "",
  [](const ArmMeasures& at) { return at.mostMass_kg / at.leastMass_kg; } };

double medianOf(const Quality& quality, const std::vector<test::UsablePlace>& places)
{
  std::vector<double> values;
  for (const test::UsablePlace& place : places)
  {
    values.push_back(quality.of(place.at));
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// By squares of 5 mm: the area that can be used, and a row for each quality of a place.
std::vector<test::UsablePlace> mapPlaneArm(const Named& arm, int coarser, Table& table)
{
  constexpr double step_m = 0.005;
  const std::vector<test::UsablePlace> places = test::usablePlaces(Arm(arm.plan), step_m);
  for (const test::UsablePlace& place : places)
  {
    const std::string at = caseName({ { "x_mm", 5.0 * place.x }, { "y_mm", 5.0 * place.y } });
    for (const Quality& quality : qualities)
    {
      if (place.x % coarser == 0 && place.y % coarser == 0)
      {
        table.info({ at, arm.name, std::string("map: ") + quality.name, quality.unit }, quality.of(place.at));
      }
    }
  }
  const double area_cm2 = 1e4 * step_m * step_m * static_cast<double>(places.size());
  table.within(
    { "half plane", arm.name, "usable, condition below 5", "cm2" }, area_cm2, arm.usable_cm2, 0.01 * arm.usable_cm2);
  return places;
}

/// The claims of textbooks: parallel is lighter and, at a place, more even; serial has more room.
void compareArms(
  const std::vector<test::UsablePlace>& serial, const std::vector<test::UsablePlace>& parallel, Table& table)
{
  table.atLeast({ "half plane", "serial over five-bar", "usable area" },
    static_cast<double>(serial.size()) / static_cast<double>(parallel.size()), 1.0);
  for (const Quality& quality : { qualities[0], qualities[3], massEvenness })
  {
    table.atMost({ "half plane", "five-bar over serial", std::string(quality.name) + ", median" },
      medianOf(quality, parallel) / medianOf(quality, serial), 1.0);
  }
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
bool growsAt(const ArmPlan& plan, const HandModel& hand, const Vec3& start_D, const Vec3& n_D, double stiffness_N_per_m)
{
  constexpr double period_s = 1e-3, off_m = 1e-6;
  constexpr int ticks = 4000, window = 400;
  ArmPlant plant(plan, hand, period_s);
  if (!plant.begin(start_D + off_m * n_D, Vec3::Zero()))
  {
    return true;
  }
  double early = 0.0, late = 0.0;
  for (int tick = 0; tick < ticks; ++tick)
  {
    const double away = n_D.dot(plant.position_D() - start_D);
    plant.step(hand.stiffness_N_per_m * start_D, { -stiffness_N_per_m * away * n_D, Vec3::Zero() });
    early = tick < window ? std::max(early, std::fabs(away)) : early;
    late = tick >= ticks - window ? std::max(late, std::fabs(away)) : late;
    if (std::fabs(away) > 1e-3)
    {
      return true;
    }
  }
  return late > early;
}

/// The direction in which a wall shakes first at a place, and its stiffness there.
struct FirstWall
{
  Vec3 direction_D = Vec3::Zero();
  double stiffness_N_per_m = std::numeric_limits<double>::infinity();
};

FirstWall firstWallAt(const ArmPlan& plan, const HandModel& hand, const Vec3& place_D)
{
  const Arm arm(plan);
  const JointVector q = *arm.inverse(place_D);
  const PrincipalPart part = *principalPartOf(arm, q, arm.posture(q));
  FirstWall first;
  for (int i = 0; i < part.count; ++i)
  {
    SampledWall wall;
    wall.mass_kg = part.mass_kg[i] + hand.mass_kg;
    wall.damping_Ns_per_m = part.damping_Ns_per_m[i] + hand.damping_Ns_per_m;
    wall.handStiffness_N_per_m = hand.stiffness_N_per_m;
    const double critical = criticalStiffness(wall);
    if (critical < first.stiffness_N_per_m)
    {
      first = { part.directions_D.col(i), critical };
    }
  }
  return first;
}

/// The stiffness from which on the simulated arm shakes, within a factor of two of a guess.
double measuredWall(const ArmPlan& plan, const HandModel& hand, const Vec3& place_D, const FirstWall& guess)
{
  double low = 0.5 * guess.stiffness_N_per_m, high = 2.0 * guess.stiffness_N_per_m;
  for (int halving = 0; halving < 10; ++halving)
  {
    const double middle = std::sqrt(low * high);
    (growsAt(plan, hand, place_D, guess.direction_D, middle) ? high : low) = middle;
  }
  return std::sqrt(low * high);
}

void judgeWall(const std::string& name, const Vec3& aside_D, Table& table)
{
  const ArmPlan plan = linearised(knownArm(name).value);
  const Vec3 place_D = plan.workSpace.centre_D + plan.workSpace.radius_m * aside_D;
  const FirstWall first = firstWallAt(plan, HandModel{}, place_D);
  table.within({ caseName({ { "x", aside_D.x() }, { "y", aside_D.y() }, { "z", aside_D.z() } }), name,
                 "stiffest wall in the worst direction", "N/m" },
    measuredWall(plan, HandModel{}, place_D, first), first.stiffness_N_per_m, 0.05 * first.stiffness_N_per_m);
}

/// The limit that the product has for an arm in a light hand is that of the worst of its places: the middle of the work
/// space and the ends of its axes and diagonals.
void judgeLimit(const DeviceModel& model, Table& table)
{
  const HandModel light{ "light", 200.0, 2.0, 0.02 };
  const ArmPlan plan = linearised(*model.arm);
  const double limit = stabilityLimits(infoOf(model), {}).stable_N_per_m;
  Vec3 worst_D = Vec3::Zero();
  FirstWall first;
  for (const int x : { -1, 0, 1 })
  {
    for (const int y : { -1, 0, 1 })
    {
      for (const int z : { -1, 0, 1 })
      {
        const Vec3 way(x, y, model.planar ? 0 : z);
        const Vec3 place_D = plan.workSpace.radius_m * way / std::max(1.0, way.norm());
        const FirstWall here = Arm(plan).inverse(place_D) ? firstWallAt(plan, light, place_D) : FirstWall{};
        if (here.stiffness_N_per_m < first.stiffness_N_per_m)
        {
          first = here;
          worst_D = place_D;
        }
      }
    }
  }
  table.within({ "work space", model.id, "limit of the product at the worst place", "N/m" }, limit,
    measuredWall(plan, light, worst_D, first), 0.05 * limit);
}

/// Speeds of the joints over the speed of the tip as libnifalcon has them: sin(theta2)^2 in place of
/// sin(theta2) sin(theta3) in the third column.
Mat3 librarysSpeeds(const DeltaGeometry& delta, const JointVector& q, const Vec3& p, const Mat3& right)
{
  Mat3 wrong = right;
  for (int leg = 0; leg < 3; ++leg)
  {
    // theta3 between the rod and the leg's across axis; theta2 of the rod in the leg's plane.
    const auto [c, s] = delta.legs[static_cast<std::size_t>(leg)];
    const double v = -p.x() * s + p.y() * c + delta.offset_m;
    const double sin3 = std::sqrt(1.0 - std::pow(v / delta.forearm_m, 2));
    const double length = delta.forearm_m * sin3 + delta.hinge_m;
    const double sin2 = (p.z() - delta.arm_m * std::sin(q[leg])) / length;
    wrong(leg, 2) *= sin2 / sin3;
  }
  return wrong;
}

/// The force that a host with a wrong matrix adds to one of 1 N, across it, in the worst direction: from a random start
/// uphill by ever smaller steps.
double largestAcross_N(const Mat3& feltOfAsked, test::Random& random)
{
  const auto across_N = [&](const Vec3& n)
  {
    const Vec3 felt = feltOfAsked * n;
    return (felt - felt.dot(n) * n).norm();
  };
  double most_N = 0.0;
  Vec3 worst = Vec3::UnitX();
  double step = 1.0;
  for (int tried = 0; tried < 2000; ++tried, step *= 0.994)
  {
    const Vec3 n = (worst + step * random.direction()).normalized();
    worst = across_N(n) > most_N ? n : worst;
    most_N = std::max(most_N, across_N(n));
  }
  return most_N;
}

struct Across
{
  double wrong_N = 0.0, right_N = 0.0;
};

/// A host with that matrix gives torques by its inverse transposed; a hand gets their force by the true one. On a
/// circle, in planes from 80 to 170 mm.
Across forceAcross(double radius_m)
{
  const ArmPlan plan = knownArm("falcon").value;
  const auto& delta = std::get<DeltaGeometry>(plan.geometry);
  const Arm arm(plan);
  Across across;
  test::Random random(3);
  for (int i = 0; i < 10 * 8; ++i)
  {
    const double turn = 2.0 * M_PI * (i % 8) / 8;
    const Vec3 p(radius_m * std::cos(turn), radius_m * std::sin(turn), 0.08 + 0.01 * (i / 8));
    const std::optional<JointVector> q = arm.inverse(p);
    if (!q)
    {
      continue;
    }
    const Mat3 J = arm.jacobian(*q).topRows<3>(), right = J.inverse();
    const Mat3 wrong = librarysSpeeds(delta, *q, p, right);
    across.wrong_N = std::max(across.wrong_N, largestAcross_N(right.transpose() * wrong.inverse().transpose(), random));
    across.right_N = std::max(across.right_N, largestAcross_N(right.transpose() * J.transpose(), random));
  }
  return across;
}

/// By differences of the inverse kinematics of libnifalcon/libnifalcon alone, with its third factor replaced: 0.29747
/// at 35 mm from the axis. At the edge of the work space, 40 mm from it, an arm is pulled across by more than .31 N
/// (.37 seen).
void judgeWrongJacobian(Table& table)
{
  const Across inside = forceAcross(0.035), edge = forceAcross(0.040);
  table.atMost({ "1 N asked for", "J^T F", "force across", "N" }, std::max(inside.right_N, edge.right_N), 1e-12);
  table.within({ "1 N asked for", "sin(theta2) twice", "force across, at most", "N" }, inside.wrong_N, 0.29747, 1e-4);
  table.atLeast({ "1 N asked for", "sin(theta2) twice", "force across at the edge", "N" }, edge.wrong_N, 0.31);
}

} // namespace arms_experiment

void runArms(const Conditions& conditions, Table& table)
{
  using namespace arms_experiment;
  std::vector<std::vector<test::UsablePlace>> places;
  for (const Named& arm : planeArms())
  {
    judgePlaneArm(arm, table);
    places.push_back(mapPlaneArm(arm, conditions.pick(8, 2, 1), table));
  }
  compareArms(places[0], places[1], table);
  conditions.progress(0.3);
  for (const char* name : { "falcon", "woodenhaptics-2015", "pantograph" })
  {
    judgeWall(name, Vec3::Zero(), table);
    judgeWall(name, Vec3(0.5, -0.5, 0.0), table);
  }
  for (const DeviceModel& model : armModels())
  {
    judgeLimit(model, table);
  }
  conditions.progress(0.9);
  judgeWrongJacobian(table);
}

} // namespace palpate::lab
