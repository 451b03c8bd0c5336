// SPDX-License-Identifier: GPL-3.0-or-later
// A tool of a session on its soft body. Judges: the exact ball of the same session, the metric of tools, statics.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "haptics/geometry/scene/SceneBuilder.h"
#include "haptics/recording/Recording.h"
#include "haptics/session/mechanism/ToolOnBody.h"
#include "haptics/session/path/PathRunner.h"
#include "haptics/tool/motion/Turn.h"
#include "testing/haptics/session/PressingHand.h"
#include "testing/support/TemporaryFolder.h"

namespace palpate::test
{
namespace
{

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(ToolOnBody, InASessionAMeshBallPressesAsTheExactBallOfTheSessionDoes)
{
  for (const double depth_m : { 1e-3, 2e-3 })
  {
    PressingHand exact, mesh;
    mesh.session.choose<ToolTask>(ballTool());
    EXPECT_TRUE(mesh.session.toolPresses());
    EXPECT_EQ(mesh.session.toolRefusal(), "");
    const Vec3 exact_N = exact.press(depth_m).force_W;
    const HapticState& state = mesh.press(depth_m);
    EXPECT_TRUE(state.mechanism.held);
    EXPECT_FALSE(state.tool.held || state.soft.felt) << "both rest";
    EXPECT_GE(state.contacts, 1);
    EXPECT_NEAR(state.force_W.z() / exact_N.z(), 1.0, 0.02) << depth_m;
    EXPECT_LT(state.force_W.head<2>().norm(), 0.01 * state.force_W.z());
    EXPECT_LT(state.force_W.z(), 0.1 * firm_N_per_m * depth_m) << "it is not rigid";
    EXPECT_EQ(mesh.session.status<MechanismTask>().soft.size(), 1U);
    const std::uint64_t ofBall = mesh.session.status<SoftTask>().snapshots;
    mesh.hold(above(2.0 * ball_m), 200);
    EXPECT_EQ(mesh.session.status<SoftTask>().snapshots, ofBall) << "the body is computed once";
  }
}

TEST(ToolOnBody, InASessionAToolThatIsABallStaysTheExactBall)
{
  SurfaceInput own;
  own.name = "block";
  own.mesh = std::make_shared<const TriangleMesh>(makeBox(Vec3::Zero(), 2.0 * middleOfPad() - Vec3(0, 0, 0.05)));
  PressingHand hand;
  hand.session.setScene(SceneBuilder().build({ own }).scene);
  hand.session.choose<ToolTask>({ std::make_shared<const ToolMesh>(makeTool(makeIcosphere(4, ball_m)).value), 0.0 });
  EXPECT_FALSE(hand.session.toolPresses());
  EXPECT_EQ(hand.session.toolRefusal(), "");
  EXPECT_TRUE(hand.press(1e-3).soft.pressed);
}

TEST(ToolOnBody, InASessionAHandThatTurnsItIsTurnedBackByTheMetricOfTools)
{
  // A box that lies on the block: of a turn about x the block leaves a part, and the spring has the rest.
  const Vec3 half(0.015, 0.015, 0.005);
  for (const double lever_u : { 0.0, 0.02 })
  {
    ToolChoice box = toolOf(makeBox(-half, half));
    box.characteristic_u = lever_u;
    PressingHand hand;
    hand.session.choose<ToolTask>(box);
    hand.hold(above(half.z() + 5e-4), 100);
    HapticState state;
    for (int i = 0; i <= 200; ++i)
    {
      state = hand.hold(above(half.z() + 5e-4 - 1e-5 * i, turnBy(Vec3(2.5e-4 * i, 0, 0))));
    }
    state = hand.hold(above(half.z() - 1.5e-3, turnBy(Vec3(0.05, 0, 0))), 1500);
    const double angle = state.mechanism.hand_W.q.angularDistance(state.proxy_W.q);
    const double arm_m = box.weighs_u();
    EXPECT_GT(angle, 1e-4);
    EXPECT_NEAR(
      state.renderedTorque_D.norm(), firm_N_per_m * arm_m * arm_m * angle, 1e-3 * state.renderedTorque_D.norm());
  }
}

TEST(ToolOnBody, InASessionFrictionIsThatOfTheSession)
{
  PressingHand hand;
  hand.session.choose<ToolTask>(ballTool());
  HapticParameters parameters = hand.session.parameters();
  parameters.contact.friction = { 0.3, 0.3 };
  ASSERT_EQ(hand.session.setParameters(parameters), "");
  hand.press(1e-3);
  Pose at = above(ball_m - 1e-3);
  for (int i = 0; i < 600; ++i)
  {
    at.p.x() += 2e-5;
    hand.hold(at);
  }
  const Vec3 force_N = hand.session.state().force_W;
  EXPECT_NEAR(-force_N.x() / force_N.z(), 0.3, 0.03);
}

TEST(ToolOnBody, InASessionAnOpenMeshIsRefusedAndTheBallPressesAsWithoutIt)
{
  TriangleMesh open = makeBox(Vec3::Constant(-0.01), Vec3::Constant(0.01));
  open.triangles.pop_back();
  PressingHand hand;
  const double alone_N = hand.press(2e-3).force_W.norm();
  ASSERT_GT(alone_N, 0.1);
  hand.session.choose<ToolTask>(toolOf(open));
  EXPECT_THAT(hand.session.toolRefusal(), AllOf(StartsWith("the tool cannot press a soft body"), HasSubstr("open")));
  EXPECT_FALSE(hand.session.toolPresses());
  const HapticState& beside = hand.press(2e-3);
  EXPECT_FALSE(beside.tool.held || beside.mechanism.held);
  EXPECT_NEAR(beside.force_W.norm(), alone_N, 1e-3 * alone_N);
  hand.session.choose<SoftTask>({});
  EXPECT_EQ(hand.session.toolRefusal(), "");
  EXPECT_TRUE(hand.hold(above(0.1), 400).tool.held);
}

TEST(ToolOnBody, InASessionAMechanismThatAPersonHoldsComesFirst)
{
  const SoftChoice block = padChoice();
  const auto own = toolOnBody("ball", makeIcosphere(2, 0.01), { "block", block.input }, 0.0);
  ASSERT_EQ(own.problem, "");
  PressingHand hand;
  hand.session.choose<ToolTask>(ballTool());
  hand.session.choose<MechanismTask>({ own.value, "own" });
  EXPECT_FALSE(hand.session.toolPresses());
  const HapticState& state = hand.hold(above(0.012), 100);
  EXPECT_TRUE(state.mechanism.held);
  EXPECT_EQ(state.contacts, 0) << "the small ball is 2 mm above the block, the tool would be in it";
}

TEST(ToolOnBody, InASessionIsReplayedBitForBit)
{
  const TemporaryFolder folder;
  const std::string file = folder.file("recording");
  {
    PressingHand hand(file);
    hand.session.choose<ToolTask>(ballTool());
    EXPECT_GT(hand.press(1e-3).force_W.z(), 0.1);
    EXPECT_EQ(hand.session.stop(), "");
  }
  const auto read = readRecording(file);
  ASSERT_TRUE(std::holds_alternative<Recording>(read)) << std::get<std::string>(read);
  const ReplayResult result = replay(std::get<Recording>(read));
  EXPECT_EQ(result.problem + result.difference, "");
  EXPECT_GT(result.ticks, 1500U);
}

PathInputs ballOnPad()
{
  PathInputs inputs;
  inputs.tool = PathTool{ "ball", std::make_shared<const TriangleMesh>(makeIcosphere(2, ball_m)) };
  inputs.body = PathBody{ "block", padChoice().input };
  inputs.path = { { 0.0, above(ball_m + 1e-3) } };
  return inputs;
}

std::string refusalOf(const PathInputs& inputs)
{
  return PathRunner(inputs).report().refusal;
}

TEST(ToolOnBody, AlongAPathHasTheColumnsOfAToolAndRefusesWhatItDoesNotFeelByName)
{
  const PathRunner runner(ballOnPad());
  EXPECT_EQ(runner.report().refusal, "");
  ASSERT_EQ(runner.columns().size(), 3U);
  EXPECT_EQ(runner.columns()[2].name, "Angle");
  EXPECT_NE(runner.body(), nullptr);
  for (const char* setting :
    { "Radius", "LineRadius", "ForceShading", "LimitRadius", "FieldDetentSpacing", "ToolCoupling" })
  {
    PathInputs set = ballOnPad();
    set.settings.put(setting, set.settings.number(setting) + 1.0);
    EXPECT_THAT(refusalOf(set), StartsWith("{" + std::string(setting) + "} has no effect on a tool")) << setting;
  }
  PathInputs open = ballOnPad();
  TriangleMesh mesh = makeBox(Vec3::Constant(-0.01), Vec3::Constant(0.01));
  mesh.triangles.pop_back();
  open.tool->mesh = std::make_shared<const TriangleMesh>(mesh);
  EXPECT_THAT(refusalOf(open), AllOf(StartsWith("ball: cannot be held: "), HasSubstr("open")));
}

TEST(ToolOnBody, AToolThatHasTheBodysNameIsToldApart)
{
  const auto made = toolOnBody("block", makeIcosphere(1, 0.01), { "block", padChoice().input }, 0.2);
  ASSERT_EQ(made.problem, "");
  const Mechanism& mechanism = made.value->mechanism;
  EXPECT_NE(mechanism.bodies[0].name, mechanism.bodies[1].name);
  EXPECT_EQ(mechanism.bodies[1].name, made.value->soft.front().name);
  EXPECT_EQ(mechanism.foundFriction, 0.2);
}

} // namespace
} // namespace palpate::test
