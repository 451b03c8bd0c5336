// SPDX-License-Identifier: GPL-3.0-or-later
// A tool that is a ball to within a bound is felt as the ball: where its mesh would be, at a part of its cost.
#include <cmath>

#include <gtest/gtest.h>

#include "ToolHand.h"
#include "haptics/recording/Recording.h"
#include "haptics/session/SessionWorkers.h"
#include "haptics/session/soft/SoftChoice.h"
#include "haptics/tool/motion/Turn.h"
#include "testing/haptics/compliance/Blocks.h"
#include "testing/support/CostSample.h"
#include "testing/support/Meshes.h"
#include "testing/support/TemporaryFolder.h"

namespace palpate::test
{
namespace
{

constexpr double ballTool_m = 0.01, slant_rad = 0.7;

ToolMesh ballTool(const std::optional<Vec3>& handle = std::nullopt)
{
  return makeTool(makeIcosphere(4, ballTool_m), handle).value;
}

/// The same mesh, of which nothing is known.
ToolMesh asMesh(ToolMesh tool)
{
  tool.simple.reset();
  return tool;
}

struct BallHand : ToolHand
{
  BallHand(const std::shared_ptr<const Scene>& scene, const ToolMesh& tool, const std::string& file = {})
  {
    this->begin(scene, { std::make_shared<const ToolMesh>(tool), 0.0 }, file);
  }
};

/// Down into a groove along y, and from one of its walls to the other.
Pose wayIntoGroove(int i)
{
  return { Vec3(0.008 * std::sin(0.05 * i), 1e-3, 0.03 - 1e-4 * i), turnBy(Vec3(0, 0, 0.01 * i)) };
}

constexpr int lengthOfWay = 300;

/// Seconds of this process for the path, a tick each pose.
double secondsOf(BallHand& hand)
{
  const ProcessorClock clock;
  const std::int64_t begin_ns = clock.now_ns();
  for (int i = 0; i < lengthOfWay; ++i)
  {
    hand.hold(wayIntoGroove(i));
  }
  return 1e-9 * static_cast<double>(clock.now_ns() - begin_ns);
}

TEST(BallTool, IsWhereItsMeshIsAndPushesAsItToWithinTheBoundRow63)
{
  const auto groove = sceneOf(makeGroove(slant_rad, 0.05));
  const ToolMesh tool = ballTool();
  ASSERT_GT(tool.ball_u(), 0.0);
  BallHand ball(groove, tool), mesh(groove, asMesh(tool));
  constexpr int settles = 400; // ticks: the rest of a step of the force is gone by then
  // In the corner of both walls, each of which holds either middle at its own distance.
  const double off_m = (tool.simple->bound_u + 2.0 * tool.restGap_u()) / std::sin(slant_rad) + 1e-7;
  double pressed_N = 0.0;
  for (int i = 0; i < lengthOfWay; i += 30)
  {
    const Pose hand = wayIntoGroove(i);
    const HapticState ofMesh = mesh.hold(hand, settles), ofBall = ball.hold(hand, settles);
    EXPECT_EQ(ofMesh.tool.ball_u, 0.0);
    EXPECT_EQ(ofBall.tool.ball_u, tool.ball_u());
    EXPECT_LE((ofBall.proxy_W.p - ofMesh.proxy_W.p).norm(), off_m) << i;
    EXPECT_LE((ofBall.force_W - ofMesh.force_W).norm(), springOfTool * off_m) << i;
    EXPECT_TRUE(ofBall.proxy_W.q.isApprox(hand.q, 1e-12)) << "it turns as the hand does";
    EXPECT_LE(ofBall.torque_D.norm(), 0.0);
    pressed_N = std::max(pressed_N, ofBall.force_W.norm());
  }
  EXPECT_GT(pressed_N, 5.0);
}

TEST(BallTool, CostsLessThanAFifthOfItsMesh)
{
  const auto groove = sceneOf(makeGroove(slant_rad, 0.05));
  BallHand ball(groove, ballTool()), mesh(groove, asMesh(ballTool()));
  const double ball_s = secondsOf(ball), mesh_s = secondsOf(mesh);
  RecordProperty("share", std::to_string(ball_s / mesh_s));
  EXPECT_LT(ball_s, 0.2 * mesh_s);
}

TEST(BallTool, OnABodyThatGivesWayListsWhatPushesItWhereTheBodyHasGoneTo)
{
  // The block of Blocks.h, turned and elsewhere, pressed along its own up.
  const Pose place{ Vec3(0.3, -0.2, 0.1), Quat(Eigen::AngleAxisd(1.1, Vec3(1, 2, -1).normalized())) };
  const Vec3 up_W = place.q * Vec3::UnitZ(), top_W = place.q * middleOfPad() + place.p;
  SoftBodyInput input = pad(4);
  for (Vec3& x_W : input.mesh.vertices_W)
  {
    x_W = place.q * x_W + place.p;
  }
  constexpr double deep_m = 0.006;
  BallHand ball(nullptr, ballTool());
  ball.session.choose<SoftTask>({ std::make_shared<const SoftBodyInput>(input), "block", 25.0 });
  Random random(testSeed(1831)); // a scene far away, without which nothing tells that the tool is a ball
  ball.session.setScene(sceneOf(shifted(makeSheet({ 0.1, 0.1, 2, 2, 0.1 }, random), Vec3(0, 0, -9))));
  const Quat level = Quat::Identity();
  ball.hold({ top_W + 0.03 * up_W, level }, 200);
  const HapticState state = ball.hold({ top_W + (ballTool_m - deep_m) * up_W, level }, 600);
  ASSERT_GT(state.tool.ball_u, 0.0);
  ASSERT_TRUE(state.soft.pressed);
  ASSERT_GE(state.tool.active, 1);
  Vec3 pushed_N = Vec3::Zero();
  for (int i = 0; i < state.tool.active; ++i)
  {
    const ToolPress& press = state.tool.presses[i];
    pushed_N += springOfTool * press.push_u * press.n_W;
    EXPECT_GT(press.n_W.dot(up_W), 0.99) << i;
    // Where the surface has gone to: below where it was, and nearly where the ball's lower end is.
    const double below_m = (top_W - press.p_W).dot(up_W);
    EXPECT_GT(below_m, 0.2 * deep_m);
    EXPECT_NEAR((press.p_W - state.proxy_W.p).norm(), ballTool().ball_u(), 0.1 * deep_m);
  }
  EXPECT_LE((pushed_N - state.force_W).norm(), 0.02 * state.force_W.norm());
}

TEST(BallTool, ListsWhatPushesItAndReplaysBitForBit)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("ball");
  BallHand ball(sceneOf(makeGroove(slant_rad, 0.05)), ballTool(), path);
  HapticState state;
  for (int i = 0; i < lengthOfWay; ++i)
  {
    state = ball.hold(wayIntoGroove(i));
  }
  ASSERT_EQ(state.tool.active, 2) << "both walls";
  Vec3 pushed_N = Vec3::Zero();
  for (int i = 0; i < state.tool.active; ++i)
  {
    const ToolPress& press = state.tool.presses[i];
    pushed_N += springOfTool * press.push_u * press.n_W;
    EXPECT_NEAR((press.p_W - state.proxy_W.p).norm(), ballTool().ball_u(), 1e-7) << "where it touches";
  }
  EXPECT_LE((pushed_N - state.force_W).norm(), 1e-6 * state.force_W.norm());
  EXPECT_EQ(ball.session.stop(), "");
  const auto read = readRecording(path);
  ASSERT_TRUE(std::holds_alternative<Recording>(read));
  const ReplayResult again = replay(std::get<Recording>(read));
  EXPECT_EQ(again.problem + again.difference, "");
  EXPECT_EQ(again.ticks, static_cast<std::uint64_t>(lengthOfWay));
}

TEST(BallTool, IsJudgedOnceForABodyHoweverOftenThatMoves)
{
  // Of a body that moves there is another scene with each picture; of one that is another there is all to be asked.
  const TriangleMesh ground = makeIcosphere(5, 0.05);
  std::vector<std::shared_ptr<const Scene>> moved, others;
  for (int i = 0; i < 20; ++i)
  {
    TriangleMesh other = ground;
    other.vertices_W.front() *= 1.0 - 1e-6 * i;
    others.push_back(sceneOf(other));
    std::vector<Surface> surfaces = others.front()->surfaces();
    surfaces.front().motion = { {}, { Vec3(1e-4 * i, 0, 0), Quat::Identity() } };
    moved.push_back(std::make_shared<const Scene>(static_cast<std::uint64_t>(i) + 2, std::move(surfaces), 0.02));
  }
  const auto seconds = [](const std::vector<std::shared_ptr<const Scene>>& scenes)
  {
    BallHand ball(scenes.front(), ballTool());
    const Pose away{ Vec3(0, 0, 1), Quat::Identity() };
    ball.hold(away, 3);
    const ProcessorClock clock;
    const std::int64_t begin_ns = clock.now_ns();
    for (const auto& scene : scenes)
    {
      ball.session.setScene(scene);
      EXPECT_GT(ball.hold(away).tool.ball_u, 0.0);
    }
    return 1e-9 * static_cast<double>(clock.now_ns() - begin_ns);
  };
  const double others_s = seconds(others), moved_s = seconds(moved);
  RecordProperty("share", std::to_string(moved_s / others_s));
  EXPECT_LT(moved_s, 0.5 * others_s);
}

TEST(BallTool, TouchesWhatBendsWhichItsMeshRefuses)
{
  const auto groove = sceneOf(makeGroove(slant_rad, 0.05));
  std::vector<Surface> surfaces = groove->surfaces();
  std::vector<Vec3> start_W = surfaces.front().tree->mesh().vertices_W;
  start_W.front().z() -= 0.001;
  surfaces.front().from = std::make_shared<const VertexStart>(std::move(start_W), surfaces.front().tree->contentHash());
  const auto bending = std::make_shared<const Scene>(2, surfaces, 0.1);
  BallHand ball(bending, ballTool()), mesh(bending, asMesh(ballTool()));
  for (int i = 0; i < lengthOfWay; ++i)
  {
    ball.hold(wayIntoGroove(i));
    mesh.hold(wayIntoGroove(i));
  }
  EXPECT_GT(ball.session.state().force_W.norm(), 1.0);
  EXPECT_EQ(ball.session.toolRefusal(), "");
  EXPECT_NE(mesh.session.toolRefusal(), "");
}

TEST(BallTool, HeldElsewhereThanInItsMiddleOrTooLargeIsFeltByItsMeshAndSaysWhy)
{
  const ToolMesh aside = ballTool(Vec3(0, 0, 0.02));
  EXPECT_EQ(aside.ball_u(), 0.0);
  EXPECT_NE(describeFelt(aside, false).find("centre"), std::string::npos);
  EXPECT_NE(describeFelt(ballTool(), true).find("5120 triangles"), std::string::npos) << "what its mesh would cost";
  EXPECT_EQ(describeFelt(asMesh(ballTool()), false), "");
  // On so fine a sheet a tick cannot look at all that the ball may touch.
  Random random(testSeed(1830));
  const auto fine = sceneOf(makeSheet({ 0.02, 0.02, 160, 160, 0.3 }, random));
  BallHand large(fine, ballTool());
  EXPECT_EQ(large.hold({ Vec3(0, 0, 0.02), Quat::Identity() }, 3).tool.ball_u, 0.0);
  EXPECT_NE(describeFelt(ballTool(), false).find("too large"), std::string::npos);
}

} // namespace
} // namespace palpate::test
