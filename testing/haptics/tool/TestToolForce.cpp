// SPDX-License-Identifier: GPL-3.0-or-later
// Rows 28, 30 and 60: the force on the hand between two updates.
#include <gtest/gtest.h>

#include <cmath>

#include "Tools.h"
#include "haptics/realtime/TripleBuffer.h"
#include "haptics/tool/servo/ToolForce.h"
#include "testing/support/AllocationGuard.h"

namespace palpate::test
{
namespace
{

constexpr double half_m = 0.02, stiffness_N_per_m = 1000.0;

struct CubeOnPlane
{
  CubeOnPlane()
  {
    Random random(testSeed(2811));
    const auto plane = makeToolScene(cleanMesh(makeSheet({ 4.0, 0.4, 80, 10, 0.3 }, random)).mesh, this->tool);
    this->move.emplace(this->tool, plane, this->tool.gyration_u);
    EXPECT_EQ(this->move->place({ Vec3(-1.5, 0, 0.03), Quat::Identity() }), "");
  }

  ToolMesh tool = makeTool(makeBox(Vec3::Constant(-half_m), Vec3::Constant(half_m))).value;
  std::optional<ToolMove> move;
};

} // namespace

TEST(ToolForce, AtRestIsTheSpringToTheToolAndItsTorqueThatOfTheTippedCubeRow60)
{
  CubeOnPlane cube;
  const Pose device_W{ Vec3(-1.5, 0, half_m - 0.001), turnBy(Vec3(0, 10.0 * M_PI / 180.0, 0)) };
  ASSERT_TRUE(settle(*cube.move, device_W));
  const ToolPush push = toolPush(cube.move->contacts(), device_W, stiffness_N_per_m, ToolCoupling::Constraints);
  const Pose& at_W = cube.move->pose_W();
  const Vec3 force_N = stiffness_N_per_m * (at_W.p - device_W.p);
  const Vec3 torque_Nm =
    stiffness_N_per_m * cube.tool.gyration_u * cube.tool.gyration_u * turnFromTo(device_W.q, at_W.q);
  EXPECT_LE((push.wrench_W.force - force_N).norm(), 1e-5 * force_N.norm());
  EXPECT_LE((push.wrench_W.torque - torque_Nm).norm(), 1e-5 * torque_Nm.norm());
  // Table 4.1b: z = 20.83698 mm, and a lift of 1.83698 mm at 1000 N/m.
  EXPECT_NEAR(push.wrench_W.force.z(), 1.83698, 1e-4);
}

TEST(ToolForce, InTheAirIsNothing)
{
  CubeOnPlane cube;
  const Pose device_W{ Vec3(-1.5, 0, 0.05), Quat::Identity() };
  cube.move->update(device_W, plenty);
  const ToolPush push = toolPush(
    cube.move->contacts(), { Vec3(-1.4, 0, 0.06), Quat::Identity() }, stiffness_N_per_m, ToolCoupling::Constraints);
  EXPECT_EQ(push.wrench_W.force, Vec3(0, 0, 0));
  EXPECT_EQ(push.wrench_W.torque, Vec3(0, 0, 0));
  EXPECT_EQ(toolPush({}, device_W, stiffness_N_per_m, ToolCoupling::Virtual).wrench_W.force, Vec3(0, 0, 0));
}

TEST(ToolForce, DoesNotDragInASlideOf100MillimetresASecondWithUpdatesAt100HertzWhereTheVirtualCouplingDoesRow30)
{
  CubeOnPlane cube;
  constexpr double speed_m_s = 0.1, tick_s = 1e-3, depth_m = 0.002;
  constexpr int ticksAnUpdate = 10;
  double dragged_N = 0.0, spring_N = 0.0;
  ToolContacts newest;
  Pose device_W;
  for (int tick = 0; tick < 1000; ++tick)
  {
    device_W = { Vec3(-1.5 + speed_m_s * tick_s * tick, 0.01, half_m - depth_m), Quat::Identity() };
    if (tick % ticksAnUpdate == 0)
    {
      ASSERT_TRUE(settle(*cube.move, device_W));
      newest = cube.move->contacts();
    }
    const Vec3 ours = toolPush(newest, device_W, stiffness_N_per_m, ToolCoupling::Constraints).wrench_W.force;
    const Vec3 theirs = toolPush(newest, device_W, stiffness_N_per_m, ToolCoupling::Virtual).wrench_W.force;
    dragged_N = std::max(dragged_N, ours.head<2>().norm());
    spring_N = std::max(spring_N, theirs.head<2>().norm());
    EXPECT_NEAR(ours.z(), stiffness_N_per_m * (depth_m + cube.tool.restGap_u()), 1e-6);
  }
  EXPECT_LE(dragged_N, 1e-12);
  // K v T, less the one tick of which the newest update is fresh.
  EXPECT_NEAR(spring_N, stiffness_N_per_m * speed_m_s * tick_s * (ticksAnUpdate - 1), 1e-6);
  EXPECT_GE(spring_N, 0.5);
}

TEST(ToolForce, IsTheGradientOfWhatItStores)
{
  CubeOnPlane cube;
  Random random(testSeed(2812));
  const Pose device_W{ Vec3(-1.5, 0, half_m - 0.002), turnBy(Vec3(0.05, 0.1, 0.02)) };
  ASSERT_TRUE(settle(*cube.move, device_W));
  const ToolContacts set = cube.move->contacts();
  constexpr double small = 1e-6;
  for (int i = 0; i < 20; ++i)
  {
    const Vec3 way = random.direction();
    const auto stored = [&](double s)
    {
      const Pose there_W{ device_W.p + s * way, device_W.q };
      return toolPush(set, there_W, stiffness_N_per_m, ToolCoupling::Constraints).stored;
    };
    const double slope = (stored(small) - stored(-small)) / (2.0 * small);
    const Vec3 force_N = toolPush(set, device_W, stiffness_N_per_m, ToolCoupling::Constraints).wrench_W.force;
    EXPECT_NEAR(force_N.dot(way), -slope, 1e-5 * stiffness_N_per_m * 0.002);
  }
}

TEST(ToolForce, IsHandedOverAndComputedWithoutAllocatingOrLocking)
{
  CubeOnPlane cube;
  const Pose device_W{ Vec3(-1.5, 0, half_m - 0.002), turnBy(Vec3(0.05, 0.1, 0.02)) };
  ASSERT_TRUE(settle(*cube.move, device_W));
  TripleBuffer<ToolContacts> buffer;
  const ToolContacts set = cube.move->contacts();
  const AllocationGuard guard;
  buffer.write(set);
  const ToolPush push = toolPush(buffer.read(), device_W, stiffness_N_per_m, ToolCoupling::Constraints);
  EXPECT_EQ(guard.allocations() + guard.frees() + guard.locks(), 0u);
  EXPECT_GT(push.wrench_W.force.z(), 0.0);
  EXPECT_GT(push.active, 0);
}

} // namespace palpate::test
