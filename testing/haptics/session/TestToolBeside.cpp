// SPDX-License-Identifier: GPL-3.0-or-later
// A tool on a soft body among other surfaces. Judges: the tool of the same session without the soft body, a finite
// element solve with all contacts at once, Coulomb's law, exact predicates.
#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "haptics/core/PoseMath.h"
#include "haptics/geometry/scene/SceneBuilder.h"
#include "haptics/mechanism/servo/StandingGuard.h"
#include "haptics/mechanism/sided/SidedSurface.h"
#include "haptics/recording/Recording.h"
#include "haptics/session/mechanism/SurfacesBeside.h"
#include "haptics/session/mechanism/ToolOnBody.h"
#include "haptics/session/path/PathRunner.h"
#include "testing/haptics/mechanism/WholeBar.h"
#include "testing/haptics/session/PressingHand.h"
#include "testing/haptics/tool/CrossingJudge.h"
#include "testing/support/TemporaryFolder.h"

namespace palpate::test
{
namespace
{

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// The block's own surface and others.
std::shared_ptr<const Scene> besideBlock(std::vector<SurfaceInput> others, unsigned workers = 1)
{
  others.insert(others.begin(), surfaceOf("block", makeBox(Vec3::Zero(), Vec3(0.1, 0.1, 0.05))));
  return SceneBuilder(workers).build(others).scene;
}

/// A ball whose lowest point is a vertex, so that a plane presses through its middle.
TriangleMesh ballOnVertex(int level, double radius_m)
{
  const TriangleMesh ball = makeIcosphere(level, radius_m);
  return rotated(ball, shortestTurn(ball.vertices_W.front(), -Vec3::UnitZ()));
}

constexpr double table_m = 0.02; ///< height of its top
const Vec3 overTable(-0.3, 0.05, table_m);

TriangleMesh table()
{
  return makeBox(Vec3(-0.5, -0.5, -0.2), Vec3(-0.1, 0.5, table_m));
}

/// That the mesh ball stays away from a surface [m].
double apart_m()
{
  return StandingGuard::rest * makeRigidMesh(ballOnVertex(3, ball_m)).value->diagonal_u;
}

TEST(ToolBeside, ARigidPlaneAwayFromTheBlockPushesAsItDoesWithoutTheBlock)
{
  for (const Pose& pose : { Pose{}, Pose{ Vec3(0.0, 0.3, 0.0), Quat(0.0, 0.0, 0.0, 1.0) } })
  {
    const Pose back{ pose.q.conjugate() * -pose.p, pose.q.conjugate() };
    TriangleMesh mesh = table();
    std::ranges::transform(mesh.vertices_W, mesh.vertices_W.begin(), [&back](const Vec3& p) { return back * p; });
    const auto scene = besideBlock({ surfaceOf("table", mesh, pose) });
    PressingHand beside, alone;
    for (PressingHand* const hand : { &beside, &alone })
    {
      hand->session.setScene(scene);
      hand->session.choose<ToolTask>(toolOf(ballOnVertex(3, ball_m)));
    }
    alone.session.choose<SoftTask>({});
    ASSERT_TRUE(beside.session.toolPresses()) << beside.session.toolRefusal();
    for (PressingHand* const hand : { &beside, &alone })
    {
      hand->hold({ overTable + Vec3(0, 0, ball_m + 1e-3), Quat::Identity() }, 400);
    }
    for (int i = 0; i <= 300; ++i)
    {
      const double deep_m = 1e-5 * (i - 100);
      const Pose at{ overTable + Vec3(0, 0, ball_m - deep_m), Quat::Identity() };
      const Vec3 force_N = beside.hold(at).force_W;
      ASSERT_NEAR(force_N.z(), firm_N_per_m * std::max(deep_m + apart_m(), 0.0), 1e-6) << i;
      ASSERT_LE(force_N.head<2>().norm(), 1e-6) << i;
      alone.hold(at);
    }
    const Pose last{ overTable + Vec3(0, 0, ball_m - 2e-3), Quat::Identity() };
    // A tool on rigid surfaces rests 2e-7 of its diagonal before them, to as much again.
    const double gap_m = 2e-7 * std::sqrt(12.0) * ball_m;
    const Vec3 own_N = alone.hold(last, 300).force_W, now_N = beside.hold(last, 300).force_W;
    EXPECT_NEAR(now_N.z() - own_N.z(), firm_N_per_m * (apart_m() - gap_m), firm_N_per_m * gap_m);
    EXPECT_LE((own_N - now_N).head<2>().norm(), 1e-6);
    EXPECT_TRUE(beside.session.state().mechanism.held && alone.session.state().tool.held);
  }
}

TEST(ToolBeside, ASoftBarIsPressedThroughOntoTheWallBehindItAsAWholeSolveSays)
{
  constexpr double step_m = 5e-5;
  const std::array<int, 3> cells{ 20, 8, 4 };
  const auto scene = SceneBuilder().build({ surfaceOf("wall", blockBelowBar()) }).scene;
  SurfacesBeside beside;
  ASSERT_TRUE(beside.follow(scene.get(), "bar"));
  ASSERT_EQ(beside.reason(), "");
  const auto made = toolOnBody("ball", makeIcosphere(3, 0.015),
    { "bar", std::make_shared<const SoftBodyInput>(bar(cells)) }, 0.0, beside.bodies());
  ASSERT_EQ(made.problem, "");
  MeshTouch touch(*made.value, firmHold());
  WholeBar whole(bar(cells));
  double before_m = gap_m, met_m = -1.0, worst_N = 0.0, most_N = 0.0;
  for (int i = 0; i <= 90; ++i)
  {
    const Vec3 hand(0.08, 0.02, barSize.z() + 0.015 - step_m * i);
    const MechanismResult& r = touch.to(hand, 1e-3, 100);
    whole.press(pressesFrom(r, 0), touch.body().snapshot->free_W);
    const double borne_N = upwards_N(pressesFrom(r, 2)), expected_N = whole.borne_N();
    met_m = borne_N > 0.0 && met_m < 0.0 ? before_m : met_m;
    before_m = whole.leastGap_m();
    most_N = std::max(most_N, expected_N);
    worst_N = std::max(worst_N, std::abs(borne_N - expected_N));
    EXPECT_NEAR(r.exact_W.force.z(), -upwards_N(pressesFrom(r, 0)), 1e-9) << "all that the tool is pushed by";
  }
  EXPECT_GE(met_m, 0.0);
  EXPECT_LE(met_m, 1e-4) << "gap left at the answer before";
  EXPECT_GT(most_N, 3.0);
  EXPECT_LE(worst_N, 0.02 * most_N);
}

TEST(ToolBeside, EachSurfaceRubsWithItsOwnFrictionAndOneWithoutWithThatOfTheSession)
{
  constexpr double own = 0.1, ofSession = 0.4;
  for (const bool hasOwn : { true, false })
  {
    SurfaceInput ice = surfaceOf("ice", table());
    ice.material.frictionStatic = ice.material.frictionKinetic = hasOwn ? own : Material::asPlanned;
    PressingHand hand;
    HapticParameters parameters = hand.session.parameters();
    parameters.contact.friction = { ofSession, ofSession };
    ASSERT_EQ(hand.session.setParameters(parameters), "");
    hand.session.setScene(besideBlock({ ice }));
    hand.session.choose<ToolTask>(toolOf(makeBox(Vec3::Constant(-0.01), Vec3::Constant(0.01))));
    Pose at{ overTable + Vec3(0, 0, 0.011), Quat::Identity() };
    hand.hold(at, 300);
    for (int i = 0; i < 200; ++i)
    {
      at.p.z() -= 1e-5;
      hand.hold(at);
    }
    for (int i = 0; i < 800; ++i)
    {
      at.p.y() += 5e-6;
      hand.hold(at);
    }
    const Vec3 force_N = hand.session.state().force_W;
    EXPECT_GT(force_N.z(), 5.0);
    EXPECT_NEAR(-force_N.y() / force_N.z(), hasOwn ? own : ofSession, 1e-3);
  }
}

/// A bone whose top is level with the block's, a centimetre beside it.
TriangleMesh bone(int level)
{
  return shifted(makeIcosphere(level, 0.1), Vec3(0.2, 0.05, -0.05));
}

TEST(ToolBeside, DraggedFromTissueOntoBoneAndBackTheForceGoesOnWithoutAStep)
{
  constexpr double stiffness_N_per_m = 1000.0, mostStep_N = 0.2;
  const auto scene = besideBlock({ surfaceOf("bone", bone(5)) });
  for (const double speed_m_per_s : { 0.02, 0.05 })
  {
    PressingHand hand;
    HapticParameters parameters = hand.session.parameters();
    parameters.stiffness_N_per_m = stiffness_N_per_m;
    parameters.contact.friction = { 0.2, 0.2 };
    ASSERT_EQ(hand.session.setParameters(parameters), "");
    hand.session.setScene(scene);
    hand.session.choose<ToolTask>(toolOf(makeIcosphere(3, ball_m)));
    Pose at = above(ball_m + 1e-3);
    hand.hold(at, 300);
    for (int i = 0; i < 300; ++i)
    {
      at.p.z() -= 1e-5;
      hand.hold(at);
    }
    Vec3 before_N = hand.hold(at, 300).force_W;
    double most_N = 0.0, onBone_N = 0.0;
    const double step_m = 1e-3 * speed_m_per_s;
    const int there = static_cast<int>(0.15 / step_m);
    for (int i = 0; i < 2 * there; ++i)
    {
      at.p.x() += i < there ? step_m : -step_m;
      const Vec3 now_N = hand.hold(at).force_W;
      most_N = std::max(most_N, (now_N - before_N).norm());
      onBone_N = i == there ? now_N.z() : onBone_N;
      before_N = now_N;
    }
    EXPECT_LE(most_N, stiffness_N_per_m * step_m + mostStep_N) << speed_m_per_s;
    // Two millimetres below the top of the bone, on which the ball stands with a vertex or a facet.
    EXPECT_NEAR(onBone_N, 2e-3 * stiffness_N_per_m, 0.1 * 2e-3 * stiffness_N_per_m) << speed_m_per_s;
  }
}

TEST(ToolBeside, NothingPassesTheTableThatComesAtHalfAMetreASecond)
{
  constexpr double rounding = 1e-6, beyond_m = 0.005;
  const TriangleMesh solid = table();
  const TriangleMesh box = makeBox(Vec3(-0.02, -0.02, -0.01), Vec3(0.02, 0.02, 0.01));
  const auto scene = besideBlock({ surfaceOf("table", solid) });
  for (const TriangleMesh& mesh : { ballOnVertex(2, ball_m), box })
  {
    const ToolMesh within = makeTool(scaled(mesh, 1.0 - rounding)).value;
    const CrossingJudge judge(*within.shape_B, *makeToolScene(cleanMesh(solid).mesh, within), 0);
    double low_m = 0.0;
    std::ranges::for_each(mesh.vertices_W, [&low_m](const Vec3& p) { low_m = std::min(low_m, p.z()); });
    PressingHand hand;
    hand.session.setScene(scene);
    hand.session.choose<ToolTask>(toolOf(mesh));
    Pose at{ overTable + Vec3(0, 0, 0.1), Quat::Identity() };
    hand.hold(at, 300);
    while (at.p.z() > table_m - low_m - beyond_m)
    {
      at.p.z() -= 5e-4;
      const Pose& tool_W = hand.hold(at).proxy_W;
      ASSERT_EQ(judge.crossings(tool_W.p, tool_W.q.toRotationMatrix()), 0U) << at.p.z();
    }
    for (int i = 0; i < 400; ++i) // a hand that is faster than contacts are looked for waits for the tool
    {
      const Pose& tool_W = hand.hold(at).proxy_W;
      ASSERT_EQ(judge.crossings(tool_W.p, tool_W.q.toRotationMatrix()), 0U) << "at rest " << i;
    }
    EXPECT_GT(hand.session.state().force_W.z(), 0.9 * firm_N_per_m * beyond_m);
  }
}

TEST(ToolBeside, ASessionIsReplayedBitForBitWithOneAndTwoBuilders)
{
  const TemporaryFolder folder;
  const std::string file = folder.file("recording");
  {
    PressingHand hand(file);
    hand.session.setScene(besideBlock({ surfaceOf("bone", bone(4)), surfaceOf("table", table()) }, 2));
    hand.session.choose<ToolTask>(toolOf(makeIcosphere(3, ball_m)));
    Pose at = above(ball_m + 1e-3);
    hand.hold(at, 300);
    for (int i = 0; i < 300; ++i)
    {
      at.p.z() -= 1e-5;
      hand.hold(at);
    }
    for (int i = 0; i < 750; ++i)
    {
      at.p.x() += 2e-4;
      hand.hold(at);
    }
    EXPECT_GT(hand.session.state().force_W.z(), 0.1);
    EXPECT_EQ(hand.session.stop(), "");
  }
  const auto read = readRecording(file);
  ASSERT_TRUE(std::holds_alternative<Recording>(read)) << std::get<std::string>(read);
  for (const unsigned workers : { 1U, 2U })
  {
    const ReplayResult result = replay(std::get<Recording>(read), {}, workers);
    EXPECT_EQ(result.problem + result.difference, "");
    EXPECT_GT(result.ticks, 1000U);
  }
}

TEST(ToolBeside, AnotherSurfaceThatIsShownWhileTheToolPressesLeavesTheForce)
{
  PressingHand hand;
  hand.session.setScene(besideBlock({}));
  hand.session.choose<ToolTask>(ballTool());
  const double before_N = hand.press(2e-3).force_W.z();
  ASSERT_GT(before_N, 0.1);
  hand.session.setScene(besideBlock({ surfaceOf("table", table()) }));
  for (int i = 0; i < 300; ++i)
  {
    ASSERT_NEAR(hand.hold(above(ball_m - 2e-3)).force_W.z(), before_N, 0.05 * before_N) << i;
  }
  EXPECT_TRUE(hand.session.toolPresses());
  const Pose onTable{ overTable + Vec3(0, 0, ball_m - 1e-3), Quat::Identity() };
  hand.hold({ onTable.p + Vec3(0, 0, 0.1), Quat::Identity() }, 200);
  EXPECT_GT(hand.hold(onTable, 1500).force_W.z(), 0.9e-3 * firm_N_per_m);
  hand.session.setScene(besideBlock({}));
  EXPECT_LT(hand.hold(onTable, 1500).force_W.z(), 1e-6) << "the table is hidden";
}

TEST(ToolBeside, ASurfaceThatIsMovedIsFeltWhereItComesToRest)
{
  const Pose lower{ Vec3(0, 0, -0.004), Quat::Identity() };
  PressingHand hand;
  hand.session.setScene(besideBlock({ surfaceOf("table", table()) }));
  hand.session.choose<ToolTask>(toolOf(ballOnVertex(3, ball_m)));
  const Pose at{ overTable + Vec3(0, 0, ball_m - 5e-3), Quat::Identity() };
  hand.hold({ at.p + Vec3(0, 0, 0.01), at.q }, 300);
  EXPECT_NEAR(hand.hold(at, 300).force_W.z(), (5e-3 + apart_m()) * firm_N_per_m, 1e-6);
  hand.session.setScene(besideBlock({ surfaceOf("table", table(), lower) }));
  EXPECT_NEAR(hand.hold(at, 1500).force_W.z(), (1e-3 + apart_m()) * firm_N_per_m, 1e-6);
}

std::string refusalBeside(const std::vector<SurfaceInput>& others)
{
  PressingHand hand;
  hand.session.setScene(besideBlock(others));
  hand.session.choose<ToolTask>(ballTool());
  const std::string refusal = hand.session.toolRefusal();
  EXPECT_EQ(hand.session.toolPresses(), refusal.empty());
  EXPECT_EQ(hand.press(1e-3).soft.felt, !refusal.empty()) << "the ball presses";
  hand.session.setScene(besideBlock({}));
  EXPECT_EQ(hand.session.toolRefusal(), "") << "they are hidden";
  return refusal;
}

TEST(ToolBeside, ASurfaceThatNoMechanismCanHaveIsNamedWithTheReasonAndTheRemedy)
{
  TriangleMesh open = table();
  open.triangles.pop_back();
  EXPECT_THAT(refusalBeside({ surfaceOf("sheet", open) }),
    AllOf(StartsWith("a tool that presses a soft body cannot touch sheet: the mesh is open"), HasSubstr("hide sheet")));
  SurfaceInput line = surfaceOf("line", {});
  TriangleMesh segments;
  segments.vertices_W = { Vec3(-0.3, 0, 0), Vec3(-0.3, 0.1, 0) };
  segments.triangles = { { 0, 1, 1 } };
  line.mesh = std::make_shared<const TriangleMesh>(segments);
  line.lineRadius_u = 0.001;
  EXPECT_THAT(refusalBeside({ line }), AllOf(HasSubstr("cannot touch line: its lines"), HasSubstr("hide line")));
  std::vector<SurfaceInput> many;
  for (std::size_t i = 0; i <= SurfacesBeside::most; ++i)
  {
    many.push_back(
      surfaceOf("table " + std::to_string(i), shifted(table(), Vec3(-0.5 * static_cast<double>(i), 0, 0))));
  }
  EXPECT_THAT(refusalBeside(many),
    AllOf(HasSubstr("cannot touch table 6"), HasSubstr("at most 6 surfaces, loose ones included, and 7")));
  many.pop_back();
  EXPECT_EQ(refusalBeside(many), "");
}

TEST(ToolBeside, ASoftBodyThatLiesInASurfaceIsNotPushedOutOfItButSaid)
{
  PressingHand hand;
  hand.session.setScene(besideBlock({ surfaceOf("skin", makeBox(Vec3::Constant(-0.05), Vec3::Constant(0.2))) }));
  hand.session.choose<ToolTask>(ballTool());
  hand.hold(above(2.0 * ball_m), 10);
  EXPECT_THAT(hand.session.toolRefusal(), AllOf(HasSubstr("block lies in skin"), HasSubstr("hide skin")));
  EXPECT_FALSE(hand.session.state().mechanism.held);
  hand.session.setScene(besideBlock({}));
  EXPECT_TRUE(hand.press(1e-3).mechanism.held);
}

TEST(ToolBeside, SurfacesOfOneNameAndOfTheToolsAreToldApart)
{
  const auto scene =
    SceneBuilder().build({ surfaceOf("tool", table()), surfaceOf("tool", shifted(table(), Vec3(-1, 0, 0))) }).scene;
  SurfacesBeside beside;
  ASSERT_TRUE(beside.follow(scene.get(), "block"));
  EXPECT_FALSE(beside.follow(scene.get(), "block")) << "nothing has changed";
  const auto made = toolOnBody("tool", makeIcosphere(1, 0.01), { "block", padChoice().input }, 0.2, beside.bodies());
  ASSERT_EQ(made.problem, "");
  std::vector<std::string> names;
  std::ranges::transform(made.value->mechanism.bodies, std::back_inserter(names), &MechanismBody::name);
  ASSERT_EQ(names.size(), 4U);
  std::ranges::sort(names);
  EXPECT_EQ(std::ranges::adjacent_find(names), names.end());
}

PathInputs ballBeside(std::vector<PathSurface> surfaces)
{
  PathInputs inputs;
  inputs.tool = PathTool{ "ball", std::make_shared<const TriangleMesh>(ballOnVertex(3, ball_m)) };
  inputs.body = PathBody{ "block", padChoice().input };
  inputs.surfaces = std::move(surfaces);
  for (int i = -100; i <= 100; ++i)
  {
    inputs.path.push_back({ 1e-3 * (i + 100), { overTable + Vec3(0, 0, ball_m - 1e-5 * i), Quat::Identity() } });
  }
  return inputs;
}

TEST(ToolBeside, AlongAPathAPlaneBesideTheBlockPushesWithTheWholeSpring)
{
  PathRunner runner(ballBeside({ { "table", std::make_shared<const TriangleMesh>(table()) } }));
  ASSERT_EQ(runner.report().refusal, "");
  const double stiffness_N_per_m = pathSettings().number("Stiffness");
  const bool whole = runner.run([](double) { return true; },
    [&](std::size_t, const PathSample& sample, const PathTick& tick)
    {
      const double deep_m = table_m + ball_m - sample.hand_W.p.z();
      EXPECT_NEAR(tick.wrench_W.force.z(), stiffness_N_per_m * std::max(deep_m + apart_m(), 0.0), 1e-6) << deep_m;
    });
  EXPECT_TRUE(whole);
  TriangleMesh open = table();
  open.triangles.pop_back();
  const PathRunner refused(ballBeside({ { "sheet", std::make_shared<const TriangleMesh>(open) } }));
  EXPECT_THAT(
    refused.report().refusal, AllOf(StartsWith("sheet: cannot be touched by a tool on a soft body: the mesh is open"),
                                HasSubstr("omit this input")));
}

} // namespace
} // namespace palpate::test
