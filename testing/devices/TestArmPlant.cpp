// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "devices/simulated/ArmPlant.h"
#include "devices/simulated/SimulatedDevice.h"
#include "haptics/arm/ArmDynamics.h"
#include "haptics/arm/file/ArmFile.h"
#include "testing/support/AllocationGuard.h"
#include "testing/support/Arms.h"

namespace palpate
{
namespace
{

constexpr double armPeriod_s = 1e-3;

/// An arm that keeps its energy: without friction, damping, steps.
ArmPlan lossless(ArmPlan plan)
{
  for (ArmJoint& joint : plan.joints)
  {
    joint.friction_Nm = joint.damping_Nms = joint.countsPerTurn = joint.torqueStep_Nm = 0.0;
    joint.maxTorque_Nm = 0.0; // no motor acts: gravity is not held
  }
  return plan;
}

double energyOf(const ArmPlant& plant)
{
  const Arm& arm = plant.arm();
  const Eigen::MatrixXd J = arm.jacobian(plant.joints()).topRows(arm.directions());
  const Eigen::VectorXd rate = J.inverse() * plant.speed_D().head(arm.directions());
  return 0.5 * rate.dot(inertiaOf(arm, plant.joints()) * rate) + test::heightEnergyOf(arm, plant.joints());
}

TEST(ArmPlant, SwingsAsItsMassesDoAndKeepsItsEnergy)
{
  ArmPlan pendulum = test::twoLinks();
  pendulum.gravity_D = { 0.0, -9.81, 0.0 };
  pendulum.joints[1].low_rad = -10.0;
  for (const ArmPlan& plan : { lossless(pendulum), lossless(knownArm("falcon").value) })
  {
    SCOPED_TRACE(plan.name);
    const auto driftAt = [&plan](double step_s)
    {
      ArmPlant plant(plan, HandModel{}, step_s);
      const Vec3 start = plan.workSpace.radius_m > 0.0 ? plan.workSpace.centre_D : Vec3(0.15, -0.15, 0.0);
      EXPECT_TRUE(plant.begin(start, Vec3(0.1, 0.05, 0.0)));
      const double before = energyOf(plant), scale = 0.5 * plan.masses.front().mass_kg * 0.1 * 0.1;
      double drift = 0.0;
      for (int tick = 0; tick < static_cast<int>(0.05 / step_s); ++tick)
      {
        plant.step(Vec3::Zero(), {});
        drift = std::max(drift, std::fabs(energyOf(plant) - before) / scale);
      }
      return drift;
    };
    const double coarse = driftAt(1e-3), fine = driftAt(1e-4);
    // Of first order: a tenth of the period leaves a tenth of the drift, so that the motion itself keeps its energy.
    EXPECT_LE(fine, 0.15 * coarse) << coarse;
    EXPECT_LE(fine, 0.05);
  }
}

TEST(ArmPlant, IsPushedAsHardAsItsApparentMassSays)
{
  const Arm arm(lossless(knownArm("falcon").value));
  const Vec3 p = arm.plan().workSpace.centre_D + Vec3(0.01, -0.02, 0.01);
  const JointVector q = *arm.inverse(p);
  const PrincipalPart part = *principalPartOf(arm, q, arm.posture(q));
  ArmPlan weightless = arm.plan();
  weightless.gravity_D.setZero();
  for (int i = 0; i < 3; ++i)
  {
    ArmPlant plant(weightless, HandModel{}, armPeriod_s);
    ASSERT_TRUE(plant.begin(p, Vec3::Zero()));
    const Vec3 n = part.directions_D.col(i);
    plant.step(0.5 * n, {});
    EXPECT_LE((plant.speed_D() - 0.5 * armPeriod_s / part.mass_kg[i] * n).norm(), 1e-9);
  }
}

TEST(ArmPlant, HoldsItselfAgainstGravityAndPushesAsCommanded)
{
  for (const char* name : { "falcon", "woodenhaptics-2015" })
  {
    SCOPED_TRACE(name);
    ArmPlan plan = knownArm(name).value;
    for (ArmJoint& joint : plan.joints)
    {
      joint.friction_Nm = joint.countsPerTurn = joint.torqueStep_Nm = 0.0;
    }
    // A hand that yields as a spring: it bears the push of the device.
    const HandModel hand = *handModel("firm");
    ArmPlant plant(plan, hand, armPeriod_s);
    const Vec3 start = plan.workSpace.centre_D;
    ASSERT_TRUE(plant.begin(start, Vec3::Zero()));
    const Vec3 force(0.5, -1.0, 0.8);
    for (int tick = 0; tick < 4000; ++tick)
    {
      plant.step(hand.stiffness_N_per_m * start, { force, Vec3::Zero() });
    }
    EXPECT_LE((hand.stiffness_N_per_m * (plant.position_D() - start) - force).norm(), 1e-6);
  }
}

TEST(ArmPlant, StopsAtTheEndOfAJointAndWhereItsLinksDoNotReach)
{
  for (const char* name : { "falcon", "woodenhaptics-2015", "pantograph" })
  {
    SCOPED_TRACE(name);
    ArmPlant plant(knownArm(name).value, HandModel{}, armPeriod_s);
    ASSERT_TRUE(plant.begin(plant.arm().plan().workSpace.centre_D, Vec3::Zero()));
    for (int tick = 0; tick < 2000; ++tick)
    {
      plant.step(Vec3(0.0, 8.0, 0.0), {});
      ASSERT_TRUE(plant.position_D().allFinite() && plant.speed_D().allFinite());
      ASSERT_TRUE(plant.arm().withinLimits(plant.joints()));
    }
    EXPECT_LE((plant.arm().forward(plant.joints())->p - plant.position_D()).norm(), 1e-10);
  }
}

TEST(SimulatedArm, ShowsItsPlaceByItsEncodersAndAllocatesNothing)
{
  ASSERT_EQ(armModels().size(), 3u);
  for (const DeviceModel& model : armModels())
  {
    SCOPED_TRACE(model.name);
    const double way_m = 0.5 * model.workspaceRadius_m;
    HandPath path;
    path.points_D = { Vec3(-way_m, 0, 0), Vec3(way_m, 0, 0) };
    SimulatedDevice device(model, *handModel("stylus"), path);
    ASSERT_EQ(device.open(), "");
    DeviceSample sample;
    double apart = 0.0;
    const test::AllocationGuard guard;
    for (int tick = 0; tick < 500; ++tick)
    {
      ASSERT_EQ(device.read(tick * armPeriod_s, sample), DeviceStatus::Ok);
      device.write({});
      apart = std::max(apart, (sample.pose_D.p - device.position_D()).norm());
      EXPECT_EQ(sample.velocity_D.linear, Vec3(Vec3::Zero()));
    }
    EXPECT_EQ(guard.allocations(), 0u);
    EXPECT_GT(apart, 0.0);
    EXPECT_LE(apart, 3.0 * model.encoderStep_m) << "three encoders, each less than a count behind";
    EXPECT_NEAR(device.position_D().x(), device.target(0.499).x(), 0.15 * way_m) << "it follows the hand";
  }
}

TEST(SimulatedArm, IsRefusedWhereItCannotMoveInAllItsDirections)
{
  EXPECT_EQ(refuseSimulation(knownArm("falcon").value), "");
  EXPECT_THAT(refuseSimulation(knownArm("polhem-v1").value), testing::HasSubstr("no masses"));
  EXPECT_THAT(refuseSimulation(test::sixJoints()), testing::HasSubstr("a motor for each direction"));
  HandPath far;
  far.points_D = { Vec3(1.0, 0, 0) };
  SimulatedDevice device(*deviceModel("simulated-falcon-arm"), *handModel("stylus"), far);
  EXPECT_THAT(device.open(), testing::HasSubstr("out of the reach"));
}

} // namespace
} // namespace palpate
