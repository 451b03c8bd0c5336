// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/scene/SceneSimplifier.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "haptics/geometry/curves/CurveSet.h"
#include "haptics/geometry/simplify/SurfaceDistance.h"
#include "testing/support/Meshes.h"
#include "testing/support/Says.h"

namespace palpate::test
{
namespace
{

constexpr double radius_u = 50.0;

Surface surfaceOf(const std::string& name, const TriangleMesh& mesh, double coat_u = 0.0)
{
  CleanResult clean = coat_u > 0.0 ? cleanSegments(mesh) : cleanMesh(mesh);
  return { name, std::make_shared<const SurfaceTree>(std::move(clean.mesh), coat_u), {} };
}

TriangleMesh segment()
{
  TriangleMesh mesh;
  mesh.vertices_W = { { 0, 0, 0 }, { 1, 0, 0 } };
  mesh.triangles = { { 0, 1, 1 } };
  return mesh;
}

/// In millimetres, and however few triangles.
SimplifyRules rules()
{
  SimplifyRules rules;
  rules.touch.scale_u_per_m = 1000.0;
  rules.leastTriangles = 0;
  return rules;
}

Scene fineAndCoarse()
{
  return Scene(1, { surfaceOf("fine", makeIcosphere(5, radius_u)), surfaceOf("coarse", makeIcosphere(2, radius_u)) });
}

TEST(SceneSimplifier, SaysAtFirstWhyASurfaceIsLeftAsItIs)
{
  Surface arrays = surfaceOf("arrays", makeIcosphere(2, radius_u));
  auto fields = std::make_shared<MaterialFields>();
  fields->stiffness_N_per_m.assign(arrays.tree->mesh().vertices_W.size(), 100.0);
  arrays.fields = fields;
  const Scene scene(
    1, { surfaceOf("curve", segment(), 0.5), surfaceOf("deforms", makeIcosphere(2, radius_u)), arrays,
         surfaceOf("small", makeIcosphere(2, radius_u)), surfaceOf("large", makeIcosphere(3, radius_u)) });
  SimplifyRules some = rules();
  some.leastTriangles = 1000; // between 320 and 1280
  const std::vector<SurfaceChoice> choices = chooseAtFirst(scene, { { false, true, false, false, false }, {} }, some);
  const std::vector<std::string> reasons{ "coarser lines are worthwhile from 64 segments shorter than 0.0312 u on",
    "moving and deforming surfaces are not simplified", "its material comes from arrays",
    "simpler surfaces are worthwhile from 1000 triangles on", "" };
  ASSERT_EQ(choices.size(), reasons.size());
  for (std::size_t i = 0; i < reasons.size(); ++i)
  {
    EXPECT_EQ(choices[i].name, scene.surfaces()[i].name);
    EXPECT_EQ(choices[i].reason, reasons[i]);
    EXPECT_EQ(choices[i].felt, choices[i].triangles);
    EXPECT_EQ(choices[i].triangles, scene.surfaces()[i].tree->mesh().triangles.size());
  }
}

TEST(SceneSimplifier, EverySurfaceOfASceneThatMovesIsTouchedAsItIs)
{
  Surface moving = surfaceOf("moving", makeIcosphere(3, radius_u));
  moving.motion.end_WS.p = { 1.0, 0.0, 0.0 };
  const Scene scene(1, { moving, surfaceOf("still", makeIcosphere(3, radius_u)) });
  ASSERT_TRUE(scene.moves());
  for (const SurfaceChoice& choice : chooseAtFirst(scene, {}, rules()))
  {
    EXPECT_TRUE(test::says(choice.reason, { "deforming", "surfaces", "simplified" }));
  }
}

TEST(SceneSimplifier, ReplacesWhatPaysAndLeavesTheRestInItsPlace)
{
  const Scene scene = fineAndCoarse();
  SceneSimplifier simplifier;
  const SimplerScene simpler = simplifier.simplify(scene, chooseAtFirst(scene, {}, rules()), rules(), 7);
  ASSERT_TRUE(simpler.scene);
  EXPECT_EQ(simpler.scene->revision(), 7U);
  EXPECT_EQ(simpler.scene->surfaces()[1].tree, scene.surfaces()[1].tree);
  const auto fine = scene.surfaces()[0].tree->mesh().triangles.size();
  EXPECT_EQ(simpler.choices[0].felt, simpler.scene->surfaces()[0].tree->mesh().triangles.size());
  EXPECT_LE(2 * simpler.choices[0].felt, fine);
  EXPECT_LE(simpler.choices[0].bound_u, ScenePlan::noticed * 1.0); // of a depth of 1 mm
  EXPECT_TRUE(test::says(simpler.choices[1].reason, { "facets", "finer", "feels" }));
  EXPECT_EQ(simpler.choices[1].felt, simpler.choices[1].triangles);
}

/// So many segments along a circle in z = 0.
TriangleMesh ring(std::uint32_t segments)
{
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < segments; ++i)
  {
    const double angle = 2 * std::numbers::pi * i / segments;
    mesh.vertices_W.emplace_back(radius_u * std::cos(angle), radius_u * std::sin(angle), 0.0);
    mesh.triangles.push_back({ i, (i + 1) % segments, (i + 1) % segments });
  }
  return mesh;
}

TEST(SceneSimplifier, CurvesAreFeltAtTheirCoarsestLevelAsTubesAndAsWalls)
{
  constexpr std::uint32_t count = 20000; // of 0.016 mm each
  const TriangleMesh lines = ring(count);
  const Surface walls = surfaceOf("walls", raiseWalls(curvesInPlane(lines).curves, 0.5));
  const Scene scene(1, { walls, surfaceOf("tubes", lines, 0.25), surfaceOf("coarse", ring(500), 0.25) });
  const SurfaceTraits traits{ {}, { Pose() } };
  SimplifyRules rules;
  rules.touch.scale_u_per_m = 1000.0;
  const std::vector<SurfaceChoice> first = chooseAtFirst(scene, traits, rules);
  EXPECT_EQ(first[0].triangles, count);
  EXPECT_EQ(first[1].triangles, count);
  EXPECT_TRUE(test::says(first[2].reason, { "coarser", "worthwhile", "64 segments", "0.0312 u" }));
  SceneSimplifier simplifier;
  const SimplerScene simpler = simplifier.simplify(scene, first, rules, 2);
  ASSERT_TRUE(simpler.scene);
  EXPECT_EQ(simpler.scene->surfaces()[2].tree, scene.surfaces()[2].tree);
  const double limit_u = ScenePlan::noticed * 1.0;
  for (std::size_t i = 0; i < 2; ++i)
  {
    const SurfaceTree& level = *simpler.scene->surfaces()[i].tree;
    const SurfaceChoice& choice = simpler.choices[i];
    EXPECT_EQ(choice.felt * (i == 0 ? 2 : 1), level.mesh().triangles.size());
    EXPECT_EQ(level.coat_u(), scene.surfaces()[i].tree->coat_u());
    EXPECT_LE(choice.bound_u, limit_u);
    const double longest_rad =
      2 * std::acos(1 - limit_u / radius_u); // whose sagitta is the limit; halving may miss it by 2
    EXPECT_LE(static_cast<double>(choice.felt), 2 * 2 * std::numbers::pi / longest_rad + 1);
    EXPECT_EQ(
      proveWithin(*scene.surfaces()[i].tree, level, 1.001 * choice.bound_u).verdict, DistanceProof::Verdict::Within);
  }
  EXPECT_TRUE(simplifier.knows(scene, first, rules));
}

TEST(SceneSimplifier, SaysWhyASurfaceItLookedForIsRefused)
{
  Random random(testSeed(4301));
  TriangleMesh crossed = makeSheet({ 20.0, 20.0, 40, 40, 0.0 }, random);
  append(crossed, shifted(crossed, { 0, 0, 0.01 })); // within the distance that nobody notices: nothing may go
  const Scene scene(1, { surfaceOf("plate", crossed) });
  SceneSimplifier simplifier;
  const SimplerScene none = simplifier.simplify(scene, chooseAtFirst(scene, {}, rules()), rules(), 2);
  EXPECT_FALSE(none.scene);
  EXPECT_TRUE(test::says(none.choices[0].reason, { "triangles", "removed", "perceptible" }));
}

TEST(SceneSimplifier, KnowsASurfaceWhileItStaysAndUnderTheSameRules)
{
  const Scene scene = fineAndCoarse();
  SceneSimplifier simplifier;
  const std::vector<SurfaceChoice> first = chooseAtFirst(scene, {}, rules());
  EXPECT_FALSE(simplifier.knows(scene, first, rules()));
  const SimplerScene once = simplifier.simplify(scene, first, rules(), 2);
  EXPECT_TRUE(simplifier.knows(scene, first, rules()));
  const SimplerScene again = simplifier.simplify(scene, first, rules(), 3);
  EXPECT_EQ(again.scene->surfaces()[0].tree, once.scene->surfaces()[0].tree);
  EXPECT_EQ(again.choices[1].reason, once.choices[1].reason);
  SimplifyRules finer = rules();
  finer.touch.penetration_m /= 2;
  EXPECT_FALSE(simplifier.knows(scene, first, finer));
  const Scene other(4, { surfaceOf("other", makeIcosphere(4, radius_u)) });
  (void)simplifier.simplify(other, chooseAtFirst(other, {}, rules()), rules(), 5);
  EXPECT_FALSE(simplifier.knows(scene, first, rules())); // it went
}

TEST(SceneSimplifier, StoppedItHasNothingAndForgetsNothing)
{
  const Scene scene = fineAndCoarse();
  SceneSimplifier simplifier;
  const std::vector<SurfaceChoice> first = chooseAtFirst(scene, {}, rules());
  (void)simplifier.simplify(scene, first, rules(), 2);
  SimplifyRules stopped = rules();
  std::stop_source source;
  source.request_stop();
  stopped.stop = source.get_token();
  const Scene other(3, { surfaceOf("other", makeIcosphere(4, radius_u)) });
  const SimplerScene none = simplifier.simplify(other, chooseAtFirst(other, {}, stopped), stopped, 4);
  EXPECT_FALSE(none.scene);
  EXPECT_TRUE(none.choices.empty());
  EXPECT_TRUE(simplifier.knows(scene, first, rules()));
}

} // namespace
} // namespace palpate::test
