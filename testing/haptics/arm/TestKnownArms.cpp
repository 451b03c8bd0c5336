// SPDX-License-Identifier: GPL-3.0-or-later
#include <numbers>

#include <gtest/gtest.h>

#include "haptics/arm/ArmDynamics.h"
#include "haptics/arm/ArmMeasures.h"
#include "haptics/arm/file/ArmFile.h"
#include "testing/support/Arms.h"

namespace palpate
{
namespace
{

constexpr double rad_per_deg = std::numbers::pi / 180.0;

Arm known(const std::string& name)
{
  const Outcome<ArmPlan> plan = knownArm(name);
  EXPECT_EQ(plan.problem, "") << name;
  return Arm(plan.value);
}

TEST(KnownArms, FalconHasTheJointsThatLibnifalconFinds)
{
  const Arm falcon = known("falcon");
  const std::vector<std::pair<Vec3, Vec3>> printed = {
    { { 0, 0, .12 }, { .417448223, .417448223, .417448223 } },
    { { .03, 0, .12 }, { .587671638, .140990555, .702454150 } },
    { { 0, .03, .12 }, { .146090284, .568573356, .716061294 } },
    { { -.02, .025, .10 }, { -.193459839, .546293020, .300572366 } },
    { { .01, -.03, .15 }, { 1.159459472, .747636735, .763572991 } },
    { { .035, .02, .135 }, { .660616934, .428567201, 1.066620708 } },
  };
  for (const auto& [p, q] : printed)
  {
    const std::optional<JointVector> found = falcon.inverse(p);
    ASSERT_TRUE(found) << p.transpose();
    // That library computes in single precision, half a step of which is 6e-8; the exact equations are in TestArm.
    EXPECT_LE((Vec3(*found) - q).cwiseAbs().maxCoeff(), 7e-8) << found->transpose();
    EXPECT_LE((falcon.forward(q)->p - p).norm(), 7e-9);
  }
}

TEST(KnownArms, FalconTurnsCountsIntoAnglesAsLibnifalconDoes)
{
  const JointVector q = known("falcon").jointsOf({ 0, 500, -500 });
  EXPECT_NEAR(q[0] / rad_per_deg, 35.0, 1e-9);
  EXPECT_NEAR(q[1] / rad_per_deg, 53.217329545, 1e-9);
  EXPECT_NEAR(q[2] / rad_per_deg, 16.782670455, 1e-9);
}

TEST(KnownArms, WoodenHapticsIsWhereTheVendorsCodeSaysWithItsCurrents)
{
  struct Printed
  {
    const char* arm;
    JointCounts counts;
    Vec3 p, current_A;
  };
  const std::vector<Printed> printed = {
    { "woodenhaptics-2015", { 0, 0, 6000 }, { .025, 0, .205 }, { .295608, .659588, -1.576577 } },
    { "woodenhaptics-2015", { 1000, -2000, 6000 }, { -.080238098, .027800371, .177535208 },
      { .101546, -.043624, -1.576577 } },
    { "woodenhaptics-2015", { -3000, 4000, 8000 }, { .104033213, -.216512071, .225 },
      { .913438, 1.325042, -1.583587 } },
    { "polhem-v1", { 1000, -2000, 6000 }, { -.163847989, .004205044, .139868217 }, { .016655, -.615163, -.401626 } },
    { "polhem-v1", { 500, -1500, -5000 }, { .071187644, -.018476525, .113035135 }, { -.128119, -.568174, .494424 } },
    { "aluhaptics-v2", { 1000, -2000, 6000 }, { -.166981787, -.010581541, .291615828 },
      { -.013363, -.474835, -1.187551 } },
  };
  for (const Printed& row : printed)
  {
    const Arm arm = known(row.arm);
    const JointVector q = arm.jointsOf(row.counts);
    EXPECT_LE((arm.forward(q)->p - row.p).cwiseAbs().maxCoeff(), 1e-9) << row.arm;
    const JointVector motor_Nm = arm.motorTorqueOf(arm.torqueOf(q, { Vec3(1, .5, -2), Vec3::Zero() }));
    for (int k = 0; k < 3; ++k)
    {
      const double constant_Nm_per_A = arm.plan().joints[static_cast<std::size_t>(k)].torqueConstant_Nm_per_A;
      EXPECT_NEAR(motor_Nm[k] / constant_Nm_per_A, row.current_A[k], 6e-7) << row.arm;
    }
  }
}

TEST(KnownArms, PantographIsWhereTheVendorsCodeSaysAndTurnsByTheTrueJacobian)
{
  const Arm pantograph = known("pantograph");
  const auto joints = [](double left_deg, double right_deg)
  {
    JointVector q(2);
    q << left_deg * rad_per_deg, right_deg * rad_per_deg;
    return q;
  };
  const std::vector<std::pair<JointVector, Vec3>> printed = {
    { joints(140, 40), { .01, .08280392, 0 } },
    { joints(170, 60), { -.01894242, .07178576, 0 } },
    { joints(120, 10), { .03894242, .07178576, 0 } },
  };
  for (const auto& [q, p] : printed)
  {
    EXPECT_LE((pantograph.forward(q)->p - p).cwiseAbs().maxCoeff(), 1e-8);
  }
  const ArmJacobian J = pantograph.jacobian(printed[0].first);
  EXPECT_LE((J.col(0).head<2>() - Eigen::Vector2d(-.03615742, -.03447153)).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_LE((J.col(1).head<2>() - Eigen::Vector2d(-.03615742, .03447153)).cwiseAbs().maxCoeff(), 1e-8);
}

TEST(KnownArms, HangingDeltaHasTheAnglesAndTheConditionOfTheTextbook)
{
  const Arm delta(test::hangingDelta());
  const std::optional<JointVector> q = delta.inverse(Vec3(.03, -.02, -.24));
  ASSERT_TRUE(q);
  EXPECT_NEAR((*q)[0] / rad_per_deg, 22.2231, 5e-5);
  EXPECT_NEAR((*q)[1] / rad_per_deg, 41.0354, 5e-5);
  EXPECT_NEAR((*q)[2] / rad_per_deg, 30.9765, 5e-5);
  EXPECT_NEAR(measure(delta, *q).condition, 1.308, 5e-4);
}

/// Stiffness of the tip, falling: eigenvalues of J^-T k J^-1 with the given stiffness of each joint [N/m].
Eigen::Vector2d tipStiffness(const ArmMeasures& at, double joint_Nm_per_rad)
{
  return { joint_Nm_per_rad / (at.singular[1] * at.singular[1]), joint_Nm_per_rad / (at.singular[0] * at.singular[0]) };
}

/// Area of the half plane above the base in which the condition number is below 5, by squares of 5 mm [cm2].
double usable_cm2(const Arm& arm)
{
  constexpr double step_m = 0.005;
  return 1e4 * step_m * step_m * static_cast<double>(test::usablePlaces(arm, step_m).size());
}

TEST(KnownArms, TwoLinksAreStifferToOneSideAndHaveMoreRoomThanAFiveBarThatIsLighterAndMoreEven)
{
  const Vec3 tip(0.0, 0.2, 0.0);
  const Arm serial(test::twoLinks()), parallel(test::fiveBar());
  const ArmMeasures s = measure(serial, *serial.inverse(tip)), p = measure(parallel, *parallel.inverse(tip));
  EXPECT_NEAR(tipStiffness(s, 10.0)[1], 188.4, 0.05);
  EXPECT_NEAR(tipStiffness(s, 10.0)[0], 1061.6, 0.05);
  EXPECT_NEAR(tipStiffness(p, 10.0)[1], 214.5, 0.05);
  EXPECT_NEAR(tipStiffness(p, 10.0)[0], 677.1, 0.05);
  EXPECT_NEAR(s.condition, 2.374, 5e-4);
  EXPECT_NEAR(p.condition, 1.777, 5e-4);
  EXPECT_NEAR(s.leastMass_kg, 0.0043, 5e-5);
  EXPECT_NEAR(s.mostMass_kg, 0.1095, 5e-5);
  EXPECT_NEAR(p.leastMass_kg, 0.0021, 5e-5);
  EXPECT_NEAR(p.mostMass_kg, 0.0068, 5e-5);
  EXPECT_NEAR(usable_cm2(serial), 1100.0, 11.0);
  EXPECT_NEAR(usable_cm2(parallel), 826.0, 8.26);
}

} // namespace
} // namespace palpate
