// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "Tools.h"
#include "haptics/tool/servo/ToolForce.h"
#include "haptics/tool/worker/ToolFollower.h"

namespace palpate::test
{
namespace
{

constexpr double cubeHalf = 0.02;

ToolMove cubeAboveAPlane(int cells)
{
  Random random(testSeed(1801));
  const ToolMesh tool = makeTool(makeBox(Vec3::Constant(-cubeHalf), Vec3::Constant(cubeHalf))).value;
  ToolMove move(
    tool, makeToolScene(cleanMesh(makeSheet({ 0.4, 0.4, cells, cells, 0.3 }, random)).mesh, tool), tool.gyration_u);
  EXPECT_EQ(move.place({ Vec3(0, 0, 0.03), Quat::Identity() }), "");
  return move;
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
  const ToolMesh tool = makeTool(makeBox(Vec3::Constant(-cubeHalf), Vec3::Constant(cubeHalf))).value;
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
  EXPECT_NEAR(follower.move().pose_W().p.z(), cubeHalf, 1e-6); // stopped outside
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

} // namespace palpate::test
