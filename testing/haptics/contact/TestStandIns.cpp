// SPDX-License-Identifier: GPL-3.0-or-later
// A hand near a noisy line or sheet stays on its side of it when a coarser one takes its place, and when it comes back.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/geometry/curves/CurveSet.h"
#include "haptics/geometry/mesh/NearestOnTriangle.h"
#include "haptics/geometry/scene/SceneSimplifier.h"
#include "testing/support/AllocationGuard.h"
#include "testing/support/Meshes.h"
#include "testing/support/Probe.h"
#include "testing/support/Random.h"

namespace palpate::test
{
namespace
{

constexpr double noise_u = 0.03, step_u = 0.005; // steps of 5 um, in millimetres
constexpr std::size_t points = 4000;

struct Felt
{
  std::shared_ptr<const Scene> full, coarse;
  double bound_u = 0.0;
};

/// Along x; y is the noise.
std::vector<double> noisyHeights(Random& random)
{
  std::vector<double> heights(points);
  for (double& height : heights)
  {
    height = random.uniform(-noise_u, noise_u);
  }
  return heights;
}

double xOf(std::size_t point)
{
  return step_u * (static_cast<double>(point) - 0.5 * static_cast<double>(points));
}

Felt felt(Surface surface, const SurfaceTraits& traits)
{
  SimplifyRules rules;
  rules.touch.scale_u_per_m = 1000.0;
  const auto full = std::make_shared<const Scene>(1, std::vector<Surface>{ std::move(surface) });
  const SimplerScene simpler = SceneSimplifier().simplify(*full, chooseAtFirst(*full, traits, rules), rules, 2);
  EXPECT_TRUE(simpler.scene) << simpler.choices[0].reason;
  return { full, simpler.scene, simpler.choices[0].bound_u };
}

/// `fold_u`: how far its points are moved along it: beyond half a step it turns back on itself.
Felt walls(const std::vector<double>& heights, double fold_u, Random& random)
{
  CurveSet curves;
  for (std::size_t i = 0; i < heights.size(); ++i)
  {
    curves.points_W.emplace_back(xOf(i) + fold_u * random.uniform(-1.0, 1.0), heights[i]);
    if (i > 0)
    {
      curves.segments.push_back({ static_cast<std::uint32_t>(i - 1), static_cast<std::uint32_t>(i) });
    }
  }
  CleanResult clean = cleanMesh(raiseWalls(curves, 0.5));
  return felt({ "wall", std::make_shared<const SurfaceTree>(std::move(clean.mesh)), {} }, { {}, { Pose() } });
}

Felt tube(const std::vector<double>& heights, double radius_u)
{
  TriangleMesh lines;
  for (std::uint32_t i = 0; i < heights.size(); ++i)
  {
    lines.vertices_W.emplace_back(xOf(i), heights[i], 0.0);
    if (i > 0)
    {
      lines.triangles.push_back({ i - 1, i, i });
    }
  }
  CleanResult clean = cleanSegments(lines);
  return felt({ "tube", std::make_shared<const SurfaceTree>(std::move(clean.mesh), radius_u), {} }, {});
}

/// A sheet that swells and sinks by the noise, in cells of 0.1 mm.
Felt sheet(std::vector<Vec3>& vertices_W, Random& random)
{
  TriangleMesh mesh = makeSheet({ 8.0, 8.0, 80, 80, 0.3 }, random);
  for (Vec3& v : mesh.vertices_W)
  {
    v.z() = noise_u * std::sin(3 * v.x() + 1.0) * std::sin(4 * v.y());
  }
  vertices_W = mesh.vertices_W;
  Surface full{ "sheet", std::make_shared<const SurfaceTree>(cleanMesh(mesh).mesh), {} };
  const Simplification simpler = simplifyWithin(*full.tree, { ScenePlan::noticed, {}, {} });
  EXPECT_TRUE(simpler.tree) << simpler.refusal;
  const Surface coarse{ "sheet", simpler.tree, {}, {}, {}, {}, { full.tree->contentHash(), simpler.bound_u } };
  return { std::make_shared<const Scene>(1, std::vector{ full }),
    std::make_shared<const Scene>(2, std::vector{ coarse }), simpler.bound_u };
}

struct Ball
{
  double radius_u = 0.0;
  double coat_u = 0.0;  ///< of the curves that it touches
  double push_u = -2.0; ///< where it is pushed to, above the touched place
};

/// Places to touch, and away from which of their coordinates a hand is pushed.
struct Places
{
  std::vector<Vec3> points_W;
  int up = 0;
};

double distanceTo(const Scene& scene, const Vec3& x_W)
{
  const TriangleMesh& mesh = scene.surfaces()[0].tree->mesh();
  double least_u = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c] : mesh.triangles)
  {
    const Vec3 foot_W = nearestOnTriangle(x_W, mesh.vertices_W[a], mesh.vertices_W[b], mesh.vertices_W[c]);
    least_u = std::min(least_u, (x_W - foot_W).norm());
  }
  return least_u;
}

/// Brings a hand there, exchanges the scenes and pushes: it must stay where it was, above (side 1) or below.
void holdsWhatIsPushed(const Felt& felt, const Places& places, const Ball& ball, Random& random)
{
  const double reach_u = ball.radius_u + ball.coat_u;
  const double least_u = reach_u - noise_u - felt.bound_u; // over the lowest of both surfaces
  for (std::size_t i = 0; i < testCount(300); ++i)
  {
    const double side = i % 2 == 0 ? 1.0 : -1.0;
    const bool coarseFirst = (i / 2) % 2 == 1;
    const Vec3 point_W = places.points_W[random.below(static_cast<std::uint32_t>(places.points_W.size()))];
    const Vec3 out_W = side * Vec3::Unit(places.up), p_W = point_W + (reach_u + random.uniform(-0.05, 0.07)) * out_W;
    Probe probe(coarseFirst ? felt.coarse : felt.full, ball.radius_u, point_W + out_W);
    probe.along(p_W, 20);
    ASSERT_GE(out_W.dot(probe.x_W()), least_u);
    for (int exchange = 0; exchange < 3; ++exchange)
    {
      const auto& next = coarseFirst == (exchange % 2 == 1) ? felt.coarse : felt.full;
      {
        const AllocationGuard guard;
        probe.changeScene(next);
        ASSERT_EQ(guard.allocations() + guard.frees() + guard.locks(), 0U);
      }
      ASSERT_GE(distanceTo(*next, probe.x_W()), reach_u - 1e-9) << "hand " << i << ", exchange " << exchange;
      ASSERT_GE(out_W.dot(probe.x_W()), least_u) << "hand " << i << ", exchange " << exchange;
      probe.to(p_W);
    }
    probe.along(point_W + ball.push_u * out_W, 20);
    ASSERT_GE(out_W.dot(probe.x_W()), least_u)
      << "hand " << i << " at " << p_W.transpose() << (coarseFirst ? ", coarse first" : ", full first");
  }
}

/// Points of a line away from its ends.
Places placesOn(const std::vector<double>& heights)
{
  Places places{ {}, 1 };
  for (std::size_t i = points / 4; i < 3 * points / 4; ++i)
  {
    places.points_W.emplace_back(xOf(i), heights[i], 0.0);
  }
  return places;
}

class StandIns : public testing::TestWithParam<double>
{
};

TEST_P(StandIns, AHandNearAWallStaysOnItsSideWhenACoarserWallComesAndGoes)
{
  for (const double fold_u : { 0.0, 0.5 * step_u, step_u })
  {
    Random random(testSeed(7310));
    const std::vector<double> heights = noisyHeights(random);
    holdsWhatIsPushed(walls(heights, fold_u, random), placesOn(heights), { GetParam(), 0.0 }, random);
  }
}

/// A hand pushed beyond the middle of a tube may roll round it, with and without an exchange: so the one is pushed less
/// deep, and of the other, which is thinner than its level is off, only that it is left where it was.
TEST_P(StandIns, AHandNearATubeStaysOnItsSideWhenACoarserTubeComesAndGoes)
{
  for (const double coat_u : { 0.5, 0.02 })
  {
    Random random(testSeed(7320));
    const std::vector<double> heights = noisyHeights(random);
    const double push_u = coat_u > 2 * noise_u ? 3 * noise_u : 1.0;
    holdsWhatIsPushed(tube(heights, coat_u), placesOn(heights), { GetParam(), coat_u, push_u }, random);
  }
}

TEST_P(StandIns, AHandNearASheetStaysOnItsSideWhenASimplerSheetComesAndGoes)
{
  Random random(testSeed(7330));
  Places places{ {}, 2 };
  const Felt felt = sheet(places.points_W, random);
  std::erase_if(places.points_W, [](const Vec3& v) { return v.head<2>().cwiseAbs().maxCoeff() > 3.0; });
  holdsWhatIsPushed(felt, places, { GetParam(), 0.0 }, random);
}

INSTANTIATE_TEST_SUITE_P(PointAndBall, StandIns, testing::Values(0.0, 0.1));

} // namespace
} // namespace palpate::test
