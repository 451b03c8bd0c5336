// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "Tools.h"
#include "haptics/core/Clock.h"
#include "haptics/tool/servo/ToolTick.h"
#include "haptics/tool/worker/ToolWorker.h"
#include "testing/support/AllocationGuard.h"
#include "testing/support/Eventually.h"

namespace palpate::test
{
namespace
{

constexpr double cubeHalf = 0.02;

ToolMove cubeAboveAPlane(int cells)
{
  Random random(testSeed(1801));
  const ToolMesh tool = makeTool(makeBox(Vec3::Constant(-cubeHalf), Vec3::Constant(cubeHalf))).tool;
  ToolMove move(
    tool, makeToolScene(cleanMesh(makeSheet({ 0.4, 0.4, cells, cells, 0.3 }, random)).mesh, tool), tool.gyration_u);
  EXPECT_EQ(move.place({ Vec3(0, 0, 0.03), Quat::Identity() }), "");
  return move;
}

ToolFeel stiff(double maxForce_N, double maxTorque_Nm)
{
  ToolFeel feel;
  feel.stiffness_N_per_m = 1000.0;
  feel.limits = SafetyLimits::none();
  feel.limits.maxForce_N = maxForce_N;
  feel.limits.maxTorque_Nm = maxTorque_Nm;
  feel.limits.maxRise_N_per_s = 150.0;
  feel.limits.maxTorqueRise_Nm_per_s = 5.0;
  return feel;
}

} // namespace

TEST(ToolFollower, PublishesNothingNewUntilAHandIsThereAndThenWhatItTouches)
{
  ToolLinks links;
  ToolFollower follower(cubeAboveAPlane(4), links);
  follower.step();
  EXPECT_TRUE(links.contacts.read().placed);
  EXPECT_EQ(links.contacts.read().count, 0u);
  links.hand.write({ { Vec3(0, 0, cubeHalf - 0.001), Quat::Identity() }, true });
  for (int i = 0; i < 20; ++i)
  {
    follower.step();
  }
  EXPECT_EQ(links.contacts.read().count, 4u); // the corners of the cube
  EXPECT_GT(links.contacts.read().revision, 1u);
}

TEST(ToolFollower, WaitsWithoutAForceUntilTheHandIsWhereTheToolIsFree)
{
  const ToolMesh tool = makeTool(makeBox(Vec3::Constant(-cubeHalf), Vec3::Constant(cubeHalf))).tool;
  const auto wall = makeToolScene(cleanMesh(makeBox(Vec3(-1, -1, -1), Vec3(1, 1, 0))).mesh, tool);
  ToolLinks links;
  ToolFollower follower(ToolMove(tool, wall, tool.gyration_u), links);
  bool cameFree = false;
  for (const double z : { 0.0, 0.01, 0.019, 0.03, 0.01 })
  {
    const Pose hand_W{ Vec3(0, 0, z), Quat::Identity() };
    links.hand.write({ hand_W, true });
    follower.step();
    cameFree = cameFree || z > cubeHalf;
    const bool pressed = cameFree && z < cubeHalf;
    EXPECT_EQ(links.report.read().placed, cameFree);
    EXPECT_EQ(toolPush(links.contacts.read(), hand_W, 1000.0, ToolCoupling::Constraints).active > 0, pressed);
  }
  EXPECT_NEAR(follower.move().pose_W().p.z(), cubeHalf, 1e-6); // held outside
}

TEST(ToolFollower, KeepsTheLastContactsOfAToolAtRestWhileUpdatesAreOutOfWorkButNotForEver)
{
  ToolLinks links;
  constexpr std::uint64_t hardlyAny = 40;
  ToolFollower follower(cubeAboveAPlane(40), links, hardlyAny);
  const std::uint64_t first = links.contacts.read().revision;
  links.hand.write({ { Vec3(0.1, 0, cubeHalf - 0.001), turnBy(Vec3(0.1, 0.3, 0.0)) }, true });
  int kept = 0;
  while (links.contacts.read().revision == first && kept < 1000)
  {
    follower.step();
    ++kept;
  }
  EXPECT_EQ(kept, ToolFollower::longestHeld + 1);
}

TEST(ToolFollower, APoseThatIsNoneMovesNothing)
{
  ToolLinks links;
  ToolFollower follower(cubeAboveAPlane(4), links);
  const Pose before_W = follower.move().pose_W();
  for (const Pose& none : { Pose{ Vec3::Zero(), Quat(0, 0, 0, 0) }, Pose{ Vec3::Zero(), Quat(2, 0, 0, 0) },
         Pose{ Vec3(0, 0, std::nan("")), Quat::Identity() } })
  {
    links.hand.write({ none, true });
    follower.step();
    EXPECT_EQ(follower.move().pose_W().p, before_W.p);
    EXPECT_TRUE(links.report.read().last.refused);
    const ToolPush push = toolPush(links.contacts.read(), none, 1000.0, ToolCoupling::Virtual);
    EXPECT_EQ(push.wrench_W.force, Vec3(0, 0, 0));
  }
}

TEST(ToolFollower, AHandThatTurnsByHalfATurnAtOnceIsFollowedToTheEnd)
{
  ToolLinks links;
  ToolFollower follower(cubeAboveAPlane(4), links);
  const Pose turned{ Vec3(0, 0, 0.1), turnBy(Vec3(0, M_PI - 1e-3, 0)) };
  links.hand.write({ turned, true });
  for (int i = 0; i < 60; ++i)
  {
    follower.step();
  }
  EXPECT_LE(turnFromTo(follower.move().pose_W().q, turned.q).norm(), 1e-6);
}

TEST(ToolWorker, FollowsAHandOnAThreadOfItsOwn)
{
  ToolLinks links;
  const ToolWorker worker(cubeAboveAPlane(4), links, perMs_ns);
  links.hand.write({ { Vec3(0, 0, cubeHalf - 0.001), Quat::Identity() }, true });
  EXPECT_TRUE(eventually([&] { return links.contacts.read().count == 4; }));
}

TEST(ToolTick, LimitsForceAndTorqueAndTheirRise)
{
  ToolMove move = cubeAboveAPlane(4);
  const Pose device_W{ Vec3(0, 0, cubeHalf - 0.005), turnBy(Vec3(0, 0.5, 0)) };
  ASSERT_TRUE(settle(move, device_W));
  ToolContacts set = move.contacts();
  set.revision = 1;
  ToolTick tick;
  const ToolFeel feel = stiff(2.0, 0.05);
  constexpr double tick_s = 1e-3;
  for (int i = 1; i <= 100; ++i)
  {
    const ToolFelt felt = tick.step(set, device_W, feel, tick_s);
    EXPECT_LE(felt.wrench.force.norm(), std::min(2.0, 150.0 * tick_s * i) * (1.0 + 1e-12));
    EXPECT_LE(felt.wrench.torque.norm(), std::min(0.05, 5.0 * tick_s * i) * (1.0 + 1e-12));
    EXPECT_TRUE(felt.limited);
  }
  const ToolPush asked = toolPush(set, device_W, 1000.0, ToolCoupling::Constraints);
  ASSERT_GT(asked.wrench_W.force.norm(), 2.0);
  ASSERT_GT(asked.wrench_W.torque.norm(), 0.05);
}

TEST(ToolTick, SaysWhatANewSetOfContactsAddsToTheEnergyAndAllocatesNothing)
{
  ToolMove move = cubeAboveAPlane(4);
  const Pose device_W{ Vec3(0, 0, cubeHalf - 0.002), Quat::Identity() };
  ToolContacts none = move.contacts();
  none.revision = 1;
  ASSERT_TRUE(settle(move, device_W));
  ToolContacts touching = move.contacts();
  touching.revision = 2;
  ToolTick tick;
  const ToolFeel feel = stiff(100.0, 10.0);
  const AllocationGuard guard;
  EXPECT_EQ(tick.step(none, device_W, feel, 1e-3).injected_J, 0.0);
  const double injected_J = tick.step(touching, device_W, feel, 1e-3).injected_J;
  EXPECT_EQ(tick.step(touching, device_W, feel, 1e-3).injected_J, 0.0);
  EXPECT_EQ(guard.allocations() + guard.locks(), 0u);
  EXPECT_NEAR(injected_J, 0.5 * 1000.0 * 0.002 * 0.002, 1e-7); // K d^2 / 2
}

} // namespace palpate::test
