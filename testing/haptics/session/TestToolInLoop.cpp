// SPDX-License-Identifier: GPL-3.0-or-later
// A session whose hand holds a tool: scenes that move and are replaced under it, recordings of it, its thread.
#include <cmath>

#include <gtest/gtest.h>

#include "ToolHand.h"
#include "haptics/recording/Recording.h"
#include "haptics/session/HapticSession.h"
#include "haptics/session/SessionWorkers.h"
#include "haptics/session/Warning.h"
#include "haptics/session/tool/ToolChoice.h"
#include "haptics/tool/motion/Turn.h"
#include "testing/haptics/recording/FlippedBits.h"
#include "testing/support/Eventually.h"
#include "testing/support/Meshes.h"
#include "testing/support/TemporaryFolder.h"

namespace palpate::test
{
namespace
{

constexpr double halfTool = 0.02;

ToolChoice cubeTool()
{
  return {
    std::make_shared<const ToolMesh>(makeTool(makeBox(Vec3::Constant(-halfTool), Vec3::Constant(halfTool))).value), 0.0
  };
}

TriangleMesh sheetAt(double z)
{
  Random random(testSeed(1803));
  return shifted(makeSheet({ 0.4, 0.4, 6, 6, 0.3 }, random), Vec3(0, 0, z));
}

/// The same surfaces, at the end of a motion to `place`.
std::shared_ptr<const Scene> movedTo(const Scene& scene, const Pose& place, std::uint64_t revision)
{
  std::vector<Surface> surfaces = scene.surfaces();
  for (Surface& surface : surfaces)
  {
    surface.motion = { surface.motion.end_WS, place };
  }
  return std::make_shared<const Scene>(revision, std::move(surfaces), 0.02);
}

class ToolInLoop
  : public testing::Test
  , protected ToolHand
{
};

TEST_F(ToolInLoop, PushesAsTheSpringFromTheHandToWhereTheToolLies)
{
  this->begin(sceneOf(sheetAt(0.0)), cubeTool());
  EXPECT_EQ(this->hold(0.03, 5).force_W, Vec3(0, 0, 0));
  const HapticState state = this->hold(halfTool - 0.003, 300);
  EXPECT_NEAR(state.force_W.z(), springOfTool * 0.003, 1e-3);
  EXPECT_LE(state.force_W.head<2>().norm(), 1e-9);
  EXPECT_NEAR(state.proxy_W.p.z(), halfTool, 1e-6);
  EXPECT_TRUE(this->session.toolReport().last.converged);
}

TEST_F(ToolInLoop, ReplaysBitForBitWithScenesThatMoveAndAreReplaced)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("recording");
  const auto sheet = sceneOf(sheetAt(0.0)), ball = sceneOf(shifted(makeIcosphere(3, 0.02), Vec3(0, 0, -0.0235)));
  this->begin(sheet, cubeTool(), path);
  constexpr int ticks = 1200;
  for (int i = 0; i < ticks; ++i)
  {
    if (i % 100 == 50)
    {
      const auto& body = i < 750 ? sheet : ball;
      this->session.setScene(i == 750 ? ball : movedTo(*body, { Vec3(0, 0, 1e-5 * i) }, static_cast<std::uint64_t>(i)));
    }
    const double s = 1e-3 * i;
    const double z = i < 20 ? 0.04 : halfTool - 0.003 * std::sin(9.0 * s);
    this->hold(
      { Vec3(0.01 * std::sin(3.0 * s), 0, z), turnBy(Vec3(0.2 * std::sin(5.0 * s), 0.3 * std::sin(4.0 * s), s)) });
  }
  EXPECT_EQ(this->session.stop(), "");
  const auto read = readRecording(path);
  ASSERT_TRUE(std::holds_alternative<Recording>(read)) << std::get<std::string>(read);
  const auto& recording = std::get<Recording>(read);
  EXPECT_GT(recording.tools.size(), 1000u);
  std::uint64_t pressed = 0, turned = 0;
  const auto count = [&](const TickOutput& output)
  {
    pressed += output.command.wrench_D.force.norm() > 0.2;
    turned += output.command.wrench_D.torque.norm() > 0.002;
  };
  const ReplayResult result = replay(recording, {}, 1, count);
  EXPECT_EQ(result.problem + result.difference, "");
  EXPECT_EQ(result.ticks, static_cast<std::uint64_t>(ticks));
  EXPECT_GT(pressed, result.ticks / 4) << "what is not felt shows nothing";
  EXPECT_GT(turned, result.ticks / 4);
}

TEST_F(ToolInLoop, EveryBitThatFlipsInARecordingOfItIsNamed)
{
  const TemporaryFolder folder;
  this->begin(sceneOf(sheetAt(0.0)), cubeTool(), folder.file("a"));
  this->hold(0.03, 5);
  this->hold(halfTool - 0.002, 40);
  EXPECT_EQ(this->session.stop(), "");
  FlippedBits(folder.file("a")).expectEachIsNamed(32, "tool");
}

TEST_F(ToolInLoop, OfARecordingBegunWhileItPressesReplaysBitForBit)
{
  const TemporaryFolder folder;
  this->begin(sceneOf(sheetAt(0.0)), cubeTool());
  this->hold(0.03, 5);
  this->hold(halfTool - 0.002, 10);
  ASSERT_EQ(this->session.record(folder.file("a")), "");
  this->hold({ Vec3(0.001, 0, halfTool - 0.002), turnBy(Vec3(0, 0.05, 0)) }, 40);
  EXPECT_EQ(this->session.stop(), "");
  const auto read = readRecording(folder.file("a"));
  ASSERT_TRUE(std::holds_alternative<Recording>(read));
  const ReplayResult result = replay(std::get<Recording>(read));
  EXPECT_EQ(result.problem + result.difference, "");
  EXPECT_EQ(result.ticks, 40u);
}

TEST(ToolReplay, WithoutItsContactsSaysThatItCannotBeRecomputed)
{
  Recording recording;
  RecordedChange change;
  change.event = { 1, EventKind::Tool, 17 };
  recording.entries.emplace_back(change);
  EXPECT_NE(replay(recording).problem, "");
}

TEST_F(ToolInLoop, ASheetThatMovesThroughItTakesItAlongOnItsSide)
{
  const auto sheet = sceneOf(sheetAt(0.0));
  this->begin(sheet, cubeTool());
  this->hold(0.03, 5);
  for (int i = 1; i <= 20; ++i)
  {
    const double height = 0.003 * i; // up to 40 mm above where the hand holds the cube's bottom
    this->session.setScene(movedTo(*sheet, { Vec3(0, 0, height) }, static_cast<std::uint64_t>(i) + 1));
    const HapticState& state = this->hold(0.03, 10);
    EXPECT_GE(state.proxy_W.p.z(), height + halfTool - 1e-9);
  }
  const HapticState& state = this->hold(0.03, 300);
  EXPECT_NEAR(state.proxy_W.p.z(), 0.06 + halfTool, 1e-6);
  EXPECT_NEAR(state.force_W.z(), springOfTool * 0.05, 1e-2);
}

TEST_F(ToolInLoop, WaitsInAReplacedSceneUntilTheHandIsWhereItIsFree)
{
  this->begin(sceneOf(sheetAt(0.0)), cubeTool());
  EXPECT_EQ(this->hold(0.03, 5).fault, Fault::None);
  this->session.setScene(sceneOf(makeBox(Vec3(-1, -1, -1), Vec3(1, 1, 0.035)))); // around the lower half of the cube
  const HapticState& inside = this->hold(0.03, 5);
  EXPECT_EQ(inside.fault, Fault::ToolWaits);
  EXPECT_EQ(inside.force_W, Vec3(0, 0, 0));
  EXPECT_EQ(this->hold(0.06, 5).fault, Fault::None);
  EXPECT_NEAR(this->hold(0.05, 300).force_W.z(), springOfTool * 0.005, 1e-3);
}

TEST_F(ToolInLoop, StaysWhereItIsInAReplacedSceneThatLeavesItRoom)
{
  this->begin(sceneOf(sheetAt(0.0)), cubeTool());
  this->hold(0.03, 5);
  this->hold(halfTool - 0.01, 300);
  this->session.setScene(sceneOf(sheetAt(-1e-4))); // the hand's cube would meet it, the tool stands above
  const HapticState& state = this->hold(halfTool - 0.01, 300);
  EXPECT_EQ(state.fault, Fault::None);
  EXPECT_NEAR(state.proxy_W.p.z(), halfTool - 1e-4, 1e-6);
}

TEST_F(ToolInLoop, CannotTouchWhatBendsAndSaysSo)
{
  const auto sheet = sceneOf(sheetAt(0.0));
  std::vector<Surface> surfaces = sheet->surfaces();
  std::vector<Vec3> start_W = surfaces.front().tree->mesh().vertices_W;
  start_W.front().z() -= 0.01;
  surfaces.front().from = std::make_shared<const VertexStart>(std::move(start_W), surfaces.front().tree->contentHash());
  this->begin(std::make_shared<const Scene>(2, surfaces, 0.1), cubeTool());
  this->hold(0.03, 5);
  EXPECT_NE(this->session.toolRefusal().find("deforming"), std::string::npos);
  EXPECT_EQ(this->hold(halfTool - 0.005, 5).force_W, Vec3(0, 0, 0));
  this->session.setScene(sheet);
  this->hold(0.03, 5);
  EXPECT_EQ(this->session.toolRefusal(), "");
  EXPECT_GT(this->hold(halfTool - 0.005, 300).force_W.z(), 1.0);
}

TEST_F(ToolInLoop, ThatBeginsInsideOfAClosedBodySaysSoUntilTheHandTakesItOutside)
{
  this->begin(sceneOf(makeBox(Vec3(-0.1, -0.1, -0.1), Vec3(0.1, 0.1, 0.1))), cubeTool());
  this->hold(0.0, 5);
  EXPECT_TRUE(this->session.state().tool.placed) << "it is free there";
  EXPECT_NE(this->session.status<ToolTask>().noWayOut.find("inside a closed body"), std::string::npos);
  this->hold(0.2, 50);
  EXPECT_NE(this->session.status<ToolTask>().noWayOut, "") << "nothing is passed";
  this->session.choose<ToolTask>({});
  this->hold(0.2, 5);
  EXPECT_EQ(this->session.status<ToolTask>().noWayOut, "");
  this->session.choose<ToolTask>(cubeTool());
  this->hold(0.2, 5);
  EXPECT_TRUE(this->session.state().tool.placed);
  EXPECT_EQ(this->session.status<ToolTask>().noWayOut, "");
}

TEST_F(ToolInLoop, ThatIsClosedAllAroundWhatIsShownSaysSo)
{
  TriangleMesh shell = makeBox(Vec3::Constant(-0.1), Vec3::Constant(0.1));
  const TriangleMesh part = makeBox(Vec3::Constant(-0.01), Vec3::Constant(0.01));
  const auto take = [&](const TriangleMesh& tool) {
    this->session.choose<ToolTask>({ std::make_shared<const ToolMesh>(makeTool(tool).value), 0.0 });
  };
  this->begin(sceneOf(part), {});
  take(shell);
  this->hold(0.0, 5);
  EXPECT_NE(this->session.status<ToolTask>().noWayOut.find("encloses"), std::string::npos);
  this->hold(0.5, 50);
  EXPECT_NE(this->session.status<ToolTask>().noWayOut, "") << "nothing is passed";
  shell.triangles.resize(10); // without its top
  take(shell);
  this->hold(0.5, 5);
  EXPECT_EQ(this->session.status<ToolTask>().noWayOut, "");
}

TEST_F(ToolInLoop, GoesOnFromWhereTheHandCameFromInASceneThatLeavesNoRoomWhereItIs)
{
  constexpr double top = 0.035, from = 0.2, at = 0.03;
  const auto far = sceneOf(shifted(sheetAt(0.0), Vec3(0, 0, -1.0)));
  this->begin(far, cubeTool());
  constexpr int ticks = 200;
  for (int i = 0; i <= ticks; ++i)
  {
    this->hold(from + (at - from) * i / ticks);
  }
  this->session.setScene(sceneOf(makeBox(Vec3(-1, -1, -1), Vec3(1, 1, top)))); // around the lower half of the cube
  constexpr int within_ticks = 50;
  const HapticState& state = this->hold(at, within_ticks);
  EXPECT_EQ(state.fault, Fault::None);
  EXPECT_NEAR(state.proxy_W.p.z(), top + halfTool, 1e-6) << "on the box, not in it";
  EXPECT_GT(state.force_W.z(), 0.0);
}

/// Tells the session that its scene is a part of a whole.
void tellPart(HapticSession& session, const Scene& scene, const Vec3& centre_W, double reach_u)
{
  HapticParameters parameters = session.parameters();
  parameters.known = { scene.geometryHash(), parameters.known.geometry, centre_W, reach_u };
  EXPECT_EQ(session.setParameters(parameters), "");
}

TEST_F(ToolInLoop, BeyondAServersPartWaitsWhereAllWasKnownAndGoesOnFromThereOrBeginsAnew)
{
  constexpr double deep = 0.005, reach = 0.1;
  const Pose on{ Vec3(0, 0, halfTool - deep), Quat::Identity() };
  const auto first = sceneOf(sheetAt(0.0)), second = sceneOf(sheetAt(-1e-6)), third = sceneOf(sheetAt(-2e-6));
  const ToolChoice tool = cubeTool();
  this->begin(first, tool);
  tellPart(this->session, *first, Vec3::Zero(), reach);
  this->hold(0.05, 5);
  ASSERT_NEAR(this->hold(on, 300).force_W.z(), springOfTool * deep, 1e-2);
  Pose hand = on;
  for (; hand.p.x() < 0.15; hand.p.x() += 1e-3)
  {
    this->hold(hand);
    const double way = this->session.state().proxy_W.p.norm() + tool.tool->reach_u;
    ASSERT_LE(way, reach + 1e-3) << "a step of the hand beyond it";
  }
  EXPECT_TRUE(this->hold(hand, 700).known.beyond);
  EXPECT_NE(warning(this->session.state(), this->session.report()).find("the tool reaches beyond"), std::string::npos);
  EXPECT_LE(this->session.state().force_W.norm(), 1e-9);
  tellPart(this->session, *second, Vec3::Zero(), 4.0 * reach); // has both places
  this->session.setScene(second);
  const HapticState& both = this->hold(hand, 700);
  EXPECT_FALSE(both.known.beyond);
  EXPECT_NEAR(both.proxy_W.p.x(), hand.p.x(), 1e-3);
  EXPECT_NEAR(both.force_W.z(), springOfTool * deep, 1e-2) << "above the sheet, where it was";
  hand.p = Vec3(-0.15, 0, 0.05); // a hand that jumps, above the sheet
  tellPart(this->session, *second, Vec3(0.15, 0, 0), reach);
  EXPECT_TRUE(this->hold(hand, 100).known.beyond);
  tellPart(this->session, *third, hand.p, reach); // has the hand alone
  this->session.setScene(third);
  const HapticState& anew = this->hold(hand, 100);
  EXPECT_FALSE(anew.known.beyond);
  EXPECT_TRUE(anew.tool.placed);
  EXPECT_LE((anew.proxy_W.p - hand.p).norm(), 1e-6);
}

TEST_F(ToolInLoop, GoesOnFromNoPlaceThatTheHandLeftLongAgoNorFromOneOfAnotherMapOrTool)
{
  constexpr double from = 0.2, at = 0.03;
  const auto far = sceneOf(shifted(sheetAt(0.0), Vec3(0, 0, -1.0)));
  const auto around = sceneOf(makeBox(Vec3(-1, -1, -1), Vec3(1, 1, 0.035)));
  enum class Case
  {
    Recent,
    Rests,
    OtherMap,
    OtherTool
  };
  for (const Case which : { Case::Recent, Case::Rests, Case::OtherMap, Case::OtherTool })
  {
    this->begin(far, cubeTool());
    constexpr int ticks = 40; // of a hand that comes by 4 mm a tick
    for (int i = 0; i <= ticks; ++i)
    {
      this->hold(from + (at - from) * i / ticks);
    }
    this->hold(at, which == Case::Rests ? 60 : 1);
    if (which == Case::OtherMap)
    {
      HapticParameters parameters = this->session.parameters();
      parameters.map.offset_W += Vec3(0.5, 0, 0);
      ASSERT_EQ(this->session.setParameters(parameters), "");
      this->hold(at);
    }
    if (which == Case::OtherTool)
    {
      this->session.choose<ToolTask>(cubeTool());
    }
    this->session.setScene(around);
    const HapticState& state = this->hold(at, 20);
    EXPECT_EQ(state.tool.placed, which == Case::Recent) << static_cast<int>(which);
    EXPECT_EQ(state.force_W.norm() > 0.0, which == Case::Recent) << static_cast<int>(which);
    EXPECT_EQ(this->session.stop(), "");
  }
}

TEST_F(ToolInLoop, ThatStoodNowhereGoesOnFromWhereTheHandCameFrom)
{
  const auto around = sceneOf(makeBox(Vec3(-1, -1, -1), Vec3(1, 1, 0.035)));
  const auto bending = [](const std::shared_ptr<const Scene>& scene)
  {
    std::vector<Surface> surfaces = scene->surfaces();
    std::vector<Vec3> start_W = surfaces.front().tree->mesh().vertices_W;
    start_W.front().z() -= 0.01;
    surfaces.front().from =
      std::make_shared<const VertexStart>(std::move(start_W), surfaces.front().tree->contentHash());
    return std::make_shared<const Scene>(2, surfaces, 0.1);
  };
  this->begin(sceneOf(shifted(sheetAt(0.0), Vec3(0, 0, -1.0))), cubeTool());
  for (int i = 0; i <= 40; ++i)
  {
    this->hold(0.2 - 0.17 * i / 40);
  }
  this->session.setScene(bending(around)); // which no mesh touches: the tool is laid down
  this->hold(0.03, 2);
  ASSERT_NE(this->session.toolRefusal(), "");
  this->session.setScene(around);
  const HapticState& state = this->hold(0.03, 20);
  EXPECT_TRUE(state.tool.placed);
  EXPECT_GT(state.force_W.z(), 0.0);
}

TEST_F(ToolInLoop, LaidDownOrExchangedWhileItPressesNeverPushesHarder)
{
  this->begin(sceneOf(sheetAt(0.0)), cubeTool());
  this->hold(0.03, 5);
  const double pressed_N = this->hold(halfTool - 0.003, 1000).force_W.norm();
  this->session.choose<ToolTask>({});
  for (int i = 0; i < 50; ++i)
  {
    const HapticState& state = this->hold(halfTool - 0.003);
    EXPECT_LE(state.force_W.norm(), pressed_N * (1.0 + 1e-6));
  }
  EXPECT_FALSE(this->session.state().tool.held);
  constexpr double blend_s = 0.03, tick_s = 0.001; // the ball is above the sheet: the rest of the force fades
  const double left_N = pressed_N * std::pow(blend_s / (blend_s + tick_s), 1000);
  EXPECT_LE(this->hold(halfTool - 0.003, 1000).force_W.norm(), left_N);
  this->session.choose<ToolTask>(cubeTool());
  EXPECT_EQ(this->hold(halfTool - 0.003, 5).fault, Fault::ToolWaits) << "it cannot begin in the sheet";
}

TEST(ToolThread, FollowsTheHandBesideTheServoAndDoesSoAgainAfterItWasLaidDown)
{
  HapticSession session;
  session.setScene(sceneOf(sheetAt(0.0)));
  session.choose<ToolTask>(cubeTool());
  ASSERT_EQ(session.start(std::make_unique<FedDevice>()), "");
  DeviceSample sample;
  const auto hold = [&](double z)
  {
    sample.pose_D.p = Vec3(0, 0, z);
    static_cast<FedDevice*>(session.device())->feed(sample);
  };
  hold(0.03);
  EXPECT_TRUE(eventually([&] { return session.state().tool.placed; }));
  hold(halfTool - 0.001);
  EXPECT_TRUE(eventually([&] { return session.state().contacts > 0; }));
  session.choose<ToolTask>({}); // its thread has nothing to do
  EXPECT_TRUE(eventually([&] { return !session.state().tool.held; }));
  hold(0.03);
  session.choose<ToolTask>(cubeTool());
  EXPECT_TRUE(eventually([&] { return session.state().tool.placed; }));
  EXPECT_EQ(session.stop(), "");
}

} // namespace
} // namespace palpate::test
