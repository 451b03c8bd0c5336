// SPDX-License-Identifier: GPL-3.0-or-later
// A hand along a path that is known before: forces, refusals and messages, for the filter and the program alike. Judge:
// F = K (proxy - hand) / scale.
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "haptics/session/path/PathRunner.h"
#include "haptics/session/settings/AutoChoice.h"
#include "haptics/session/settings/SessionSettings.h"
#include "testing/support/Meshes.h"

namespace palpate
{
namespace
{

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;
using test::makeBox;

constexpr double infinity = std::numeric_limits<double>::infinity();

PathSurface boxOf(const std::string& name, const Vec3& low_W, const Vec3& high_W)
{
  return { name, std::make_shared<const TriangleMesh>(makeBox(low_W, high_W)) };
}

/// A floor whose top is z = 0, and a hand that goes down to 0.25 below it.
PathInputs floorAndHand()
{
  PathInputs inputs;
  inputs.surfaces = { boxOf("floor", Vec3(-8, -8, -4), Vec3(8, 8, 0)) };
  inputs.path = { { 0.0, { Vec3(0.5, 0.25, 1.0), Quat::Identity() } },
    { 0.001, { Vec3(0.5, 0.25, -0.25), Quat::Identity() } } };
  return inputs;
}

std::vector<PathTick> ticksOf(PathRunner& runner)
{
  EXPECT_EQ(runner.report().refusal, "");
  std::vector<PathTick> ticks;
  EXPECT_TRUE(runner.run([](double) { return true; },
    [&ticks](std::size_t, const PathSample&, const PathTick& tick) { ticks.push_back(tick); }));
  return ticks;
}

std::string refusalOf(const PathInputs& inputs)
{
  return PathRunner(inputs).report().refusal;
}

TEST(PathRunner, OneSurfaceOrTwoPushByTheStiffnessTimesTheDepthOverTheScale)
{
  PathInputs inputs = floorAndHand();
  inputs.settings.put("Stiffness", 512.0);
  inputs.settings.put("Scale", 1000.0);
  inputs.surfaces.push_back(boxOf("wall", Vec3(-8, -8, -4), Vec3(0, 8, 8)));
  inputs.path.push_back({ 0.002, { Vec3(-0.5, 0.25, -0.25), Quat::Identity() } });
  PathRunner runner(inputs);
  const std::vector<PathTick> ticks = ticksOf(runner);
  ASSERT_EQ(ticks.size(), 3U);
  EXPECT_LT((ticks[1].wrench_W.force - 0.512 * Vec3(0.0, 0.0, 0.25)).norm(), 1e-12);
  EXPECT_LT((ticks[2].wrench_W.force - 0.512 * Vec3(0.5, 0.0, 0.25)).norm(), 1e-12);
  EXPECT_EQ(ticks[2].contacts, 2);
  EXPECT_THAT(runner.columns(), IsEmpty());
  EXPECT_THAT(runner.report().notes, IsEmpty());
}

/// A hand at these places, a millisecond apart.
std::vector<PathSample> pathOf(const std::vector<Vec3>& places_W)
{
  std::vector<PathSample> path;
  for (const Vec3& place_W : places_W)
  {
    path.push_back({ 1e-3 * static_cast<double>(path.size()), { place_W, Quat::Identity() } });
  }
  return path;
}

TEST(PathRunner, ABallRestsItsRadiusAboveTheFloorAndLettingGoIsFree)
{
  PathInputs inputs = floorAndHand();
  inputs.settings.put("Radius", 0.25);
  inputs.path = pathOf({ Vec3(0.5, 0.25, 1.0), Vec3(0.5, 0.25, -0.5), Vec3(0.5, 0.25, 0.5) });
  PathRunner runner(inputs);
  const std::vector<PathTick> ticks = ticksOf(runner);
  EXPECT_LT((ticks[1].proxy_W.p - Vec3(0.5, 0.25, 0.25)).norm(), 1e-12);
  EXPECT_LT((ticks[1].wrench_W.force - 1000.0 * Vec3(0.0, 0.0, 0.75)).norm(), 1e-9);
  EXPECT_EQ(ticks[2].wrench_W.force, Vec3(Vec3::Zero()));
  EXPECT_EQ(ticks[2].contacts, 0);
}

TEST(PathRunner, FrictionHoldsUpToTheStaticConeThenBrakesWithTheKineticOne)
{
  constexpr double depth_u = 0.5, statical = 0.5, kinetic = 0.25;
  PathInputs inputs = floorAndHand();
  inputs.settings.put("FrictionStatic", statical);
  inputs.settings.put("FrictionKinetic", kinetic);
  std::vector<Vec3> places_W{ Vec3(0.25, 0.25, 1.0) };
  for (int k = 0; k <= 32; ++k)
  {
    places_W.push_back(Vec3(0.25 + k / 64.0, 0.25, -depth_u));
  }
  inputs.path = pathOf(places_W);
  PathRunner runner(inputs);
  const std::vector<PathTick> ticks = ticksOf(runner);
  for (std::size_t i = 1; i < ticks.size(); ++i)
  {
    const double drawn_u = places_W[i].x() - 0.25;
    const double behind_u = drawn_u <= statical * depth_u ? drawn_u : kinetic * depth_u;
    EXPECT_LT((ticks[i].wrench_W.force - 1000.0 * Vec3(-behind_u, 0.0, depth_u)).norm(), 1e-9) << drawn_u;
  }
}

TEST(PathRunner, CurvesAreTubesOfTheirRadius)
{
  auto segments = std::make_shared<TriangleMesh>();
  segments->vertices_W = { Vec3(-2, 0, 0), Vec3(2, 0, 0) };
  segments->triangles = { { 0, 1, 1 } };
  PathInputs inputs = floorAndHand();
  inputs.surfaces = { { "line", segments, nullptr, true } };
  inputs.settings.put("Radius", 0.25);
  inputs.settings.put("LineRadius", 0.5);
  inputs.path = pathOf({ Vec3(0.5, 0.0, 1.0), Vec3(0.5, 0.0, 0.5) });
  PathRunner runner(inputs);
  const std::vector<PathTick> ticks = ticksOf(runner);
  EXPECT_LT((ticks[1].proxy_W.p - Vec3(0.5, 0.0, 0.75)).norm(), 1e-12);
  EXPECT_LT((ticks[1].wrench_W.force - 1000.0 * Vec3(0.0, 0.0, 0.25)).norm(), 1e-9);
}

TEST(PathRunner, ARunEndsWhereItIsAskedTo)
{
  PathInputs inputs = floorAndHand();
  for (int i = 2; i < 5000; ++i)
  {
    inputs.path.push_back({ i * 0.001, inputs.path.back().hand_W });
  }
  PathRunner runner(inputs);
  std::size_t taken = 0;
  EXPECT_FALSE(runner.run([&taken](double) { return taken < 1000; },
    [&taken](std::size_t, const PathSample&, const PathTick&) { ++taken; }));
  EXPECT_GE(taken, 1000U);
  EXPECT_LT(taken, 5000U);
}

TEST(PathRunner, EveryNumberThatCannotBeIsRefusedByTheNameOfItsSetting)
{
  int asked = 0;
  for (const Setting& setting : sessionSettings())
  {
    for (std::size_t i = 0; i < setting.defaults.size() && isOfPath(setting); ++i)
    {
      for (const double bad : { std::nan(""), infinity, -infinity })
      {
        PathInputs inputs = floorAndHand();
        SettingValue value = inputs.settings.of(setting.name);
        value.numbers[i] = bad;
        inputs.settings.put(setting.name, value);
        EXPECT_THAT(refusalOf(inputs), StartsWith("{" + std::string(setting.name) + "}: ")) << bad;
        ++asked;
      }
    }
  }
  EXPECT_GT(asked, 100);
}

TEST(PathRunner, KineticFrictionAboveTheStaticOneIsRefused)
{
  PathInputs inputs = floorAndHand();
  inputs.settings.put("FrictionStatic", 0.2);
  inputs.settings.put("FrictionKinetic", 0.3);
  EXPECT_THAT(refusalOf(inputs), StartsWith("{FrictionStatic}, {FrictionKinetic}: "));
}

TEST(PathRunner, WhatAToolDoesNotFeelIsRefusedByItsName)
{
  PathInputs inputs = floorAndHand();
  inputs.path.pop_back();
  inputs.path.front().hand_W.p.z() = 4.0;
  inputs.tool = PathTool{ "cube", std::make_shared<const TriangleMesh>(makeBox(Vec3(-1, -1, -1), Vec3(1, 1, 1))) };
  EXPECT_EQ(refusalOf(inputs), "");
  for (const char* setting : { "Radius", "LineRadius", "ForceShading", "LimitRadius", "FieldDetentSpacing", "SoftRate" })
  {
    PathInputs set = inputs;
    set.settings.put(setting, set.settings.number(setting) + 1.0);
    EXPECT_THAT(refusalOf(set), StartsWith("{" + std::string(setting) + "} has no effect on a tool"));
  }
  for (const char* setting : { "ToolLever", "MechanismTurning" })
  {
    PathInputs set = inputs;
    set.settings.put(setting, 2.0);
    EXPECT_EQ(refusalOf(set), "") << setting;
  }
  PathInputs bare = inputs;
  bare.surfaces.clear();
  EXPECT_THAT(refusalOf(bare), HasSubstr("there are none"));
  inputs.path.front().hand_W.p.z() = 0.5; // half of the cube is in the floor
  EXPECT_THAT(refusalOf(inputs), AllOf(StartsWith("cube: "), HasSubstr("free position")));
}

TEST(PathRunner, AToolAddsItsTurnAndTorqueToEachTick)
{
  PathInputs inputs = floorAndHand();
  inputs.tool = PathTool{ "cube", std::make_shared<const TriangleMesh>(makeBox(Vec3(-1, -1, -1), Vec3(1, 1, 1))) };
  inputs.path[0].hand_W.p = Vec3(0.0, 0.0, 3.0);
  inputs.path[1].hand_W.p = Vec3(0.0, 0.0, 0.75);
  PathRunner runner(inputs);
  const std::vector<PathTick> ticks = ticksOf(runner);
  std::size_t values = 0;
  for (const PathColumn& column : runner.columns())
  {
    values += static_cast<std::size_t>(column.components);
  }
  const double gap_u = 2e-7 * std::sqrt(12.0); // at which a tool rests: of its diagonal
  ASSERT_EQ(ticks.back().more.size(), values);
  EXPECT_NEAR(ticks.back().wrench_W.force.z(), 1000.0 * (0.25 + gap_u), 1000.0 * gap_u);
  EXPECT_NEAR(std::abs(ticks.back().more.front()), 1.0, 1e-9) << "it does not turn";
}

TEST(PathRunner, WallsInAPlaneAreOfCurvesAlone)
{
  PathInputs inputs = floorAndHand();
  inputs.settings.put("LinesAsWalls", static_cast<double>(AutoChoice::On));
  EXPECT_THAT(refusalOf(inputs), StartsWith("floor: a plane world"));
  inputs.settings.put("ForceShading", 1.0);
  EXPECT_THAT(refusalOf(inputs), StartsWith("{ForceShading} cannot be combined"));
}

TEST(PathRunner, ARadiusOfLinesWithoutLinesIsRefused)
{
  PathInputs inputs = floorAndHand();
  inputs.settings.put("LineRadius", 0.5);
  EXPECT_THAT(refusalOf(inputs), AllOf(StartsWith("floor: "), HasSubstr("no lines"), HasSubstr("{LineRadius}")));
}

TEST(PathRunner, AnArrayThatNoSurfaceHasIsRefusedAndOneThatSomeLackIsARemark)
{
  PathInputs inputs = floorAndHand();
  inputs.surfaces.front().materialProblem = "it has no array 'x'";
  EXPECT_EQ(refusalOf(inputs), "floor: it has no array 'x'");
  inputs.surfaces.front().materialNote = "its own stiffness";
  inputs.surfaces.push_back(boxOf("wall", Vec3(-8, -8, -4), Vec3(0, 8, 8)));
  const PathRunner runner(inputs);
  EXPECT_EQ(runner.report().refusal, "");
  EXPECT_THAT(runner.report().remarks, Contains("floor: its own stiffness"));
}

TEST(PathRunner, AFieldWithoutAnArrayAndAnArrayThatIsFeltInNoWayAreRefused)
{
  PathInputs inputs = floorAndHand();
  inputs.settings.put("FieldDrag", 1.0);
  EXPECT_THAT(refusalOf(inputs), HasSubstr("no array"));
  inputs.settings.put("FieldDrag", 0.0);
  inputs.settings.put("FieldArray", std::string("f"));
  EXPECT_THAT(refusalOf(inputs), HasSubstr("no force"));
}

TEST(PathRunner, ASentenceGetsTheNamesThatAPersonKnows)
{
  const auto option = [](std::string_view setting) { return "--" + std::string(setting); };
  EXPECT_EQ(withNames("{Radius}: too large; {LimitRadius} or {Radius}", option),
    "--Radius: too large; --LimitRadius or --Radius");
  EXPECT_EQ(withNames("a {name} of no setting stays", option), "a {name} of no setting stays");
}

} // namespace
} // namespace palpate
