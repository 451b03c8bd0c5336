// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces of each kind on which contact is hard, under a hand that looks for trouble; every tick is judged by itself.
// PALPATE_TEST_COUNT=1000000 PALPATE_TEST_MESHES=300 is the whole of it: so many ticks on so many surfaces of each
// kind.
#include <array>
#include <cmath>
#include <iostream>

#include <gtest/gtest.h>

#include "testing/support/Families.h"
#include "testing/support/FeatureHand.h"
#include "testing/support/Meshes.h"
#include "testing/support/TickJudge.h"

namespace palpate::test
{
namespace
{

/// A point or ball, with or without friction.
struct Tool
{
  const char* name;
  bool ball, rough;
};

/// Friction up to 5, balls of 1e-6 to half a triangle.
ContactPlan somePlan(const Tool& tool, double triangle_u, Random& random)
{
  ContactPlan plan;
  plan.radius_u = tool.ball ? triangle_u * std::pow(10.0, random.uniform(-6, -0.3)) : 0.0;
  if (tool.rough)
  {
    plan.friction.statical = std::array{ 0.1, 0.4, 1.0, 5.0 }[random.below(4)];
    plan.friction.kinetic = random.uniform(0.5, 1.0) * plan.friction.statical;
  }
  return plan;
}

/// The result of a hand, and of its ticks that end within a few triangles: a longer slide is over more of them than a
/// tick has passes, and goes on in the next.
struct RunOn
{
  TickFigures figures;
  std::uint64_t shortTicks = 0, shortOnesCut = 0;
};

RunOn runOn(const TriangleMesh& raw, const Tool& tool, std::uint64_t ticks, Random& random)
{
  constexpr double few = 8.0;
  const TriangleMesh mesh = cleanMesh(raw).mesh;
  const auto scene = sceneOf(raw);
  FeatureHand hand(mesh, random.next());
  const ContactPlan plan = somePlan(tool, hand.triangle_u(), random);
  TickJudge judge(PathChecker(mesh, 0.0), plan, hand.size_u());
  GodObjectState state;
  RunOn run;
  run.figures.notPlaced += moveGodObject(*scene, plan, hand.outside_W(), state).seatFailed;
  for (std::uint64_t i = 0; i < ticks && state.x_W.allFinite(); ++i)
  {
    const Vec3 before_W = state.x_W, p_W = hand.next();
    const ContactResult result = moveGodObject(*scene, plan, p_W, state, &judge);
    judge.judge(before_W, p_W, result, state.x_W);
    const bool isShort = (p_W - before_W).norm() < few * hand.triangle_u();
    run.shortTicks += isShort;
    run.shortOnesCut += isShort && (result.capped || result.overBudget);
  }
  run.figures += judge.figures();
  return run;
}

class HardSurfaces : public ::testing::TestWithParam<std::tuple<Family, Tool>>
{
};

TEST_P(HardSurfaces, HoldNothingThatIsFreeAndLetNothingThrough)
{
  const auto& [family, tool] = GetParam();
  const std::uint64_t seed = testSeed(2801), meshes = testMeshes(40), ticks = testCount(40000) / meshes;
  TickFigures all;
  std::uint64_t shortTicks = 0, shortOnesCut = 0;
  for (std::uint64_t i = 0; i < meshes; ++i)
  {
    Random random(seed + 1000003 * i);
    const RunOn run = runOn(family.make(random), tool, ticks, random);
    const TickFigures& figures = run.figures;
    EXPECT_TRUE(figures.clean()) << "surface " << i << " of seed " << seed << ": " << figures.text() << "\n"
                                 << figures.first;
    all += figures;
    shortTicks += run.shortTicks;
    shortOnesCut += run.shortOnesCut;
  }
  std::cout << family.name << ", " << tool.name << ": " << all.text() << "; of " << shortTicks << " short ticks "
            << shortOnesCut << " were cut" << std::endl;
  EXPECT_GT(all.held, all.ticks / 20);
  EXPECT_GT(shortTicks, all.ticks / 20);
  EXPECT_LE(shortOnesCut, shortTicks / 20); // most that is judged is judged where it came to rest
}

constexpr std::array tools = { Tool{ "Points", false, false }, Tool{ "Balls", true, false },
  Tool{ "RoughPoints", false, true }, Tool{ "RoughBalls", true, true } };

INSTANTIATE_TEST_SUITE_P(All, HardSurfaces,
  ::testing::Combine(::testing::ValuesIn(families()), ::testing::ValuesIn(tools)),
  [](const auto& info) { return std::string(std::get<0>(info.param).name) + std::get<1>(info.param).name; });

} // namespace
} // namespace palpate::test
