// SPDX-License-Identifier: GPL-3.0-or-later
// Up to the largest radius of a scene no tick runs out of its work, far above it some do.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "haptics/contact/RadiusLimit.h"
#include "testing/support/Meshes.h"
#include "testing/support/NoisySphere.h"
#include "testing/support/SpherePlay.h"

namespace palpate::test
{
namespace
{

constexpr double sphere_mm = 50.0;
constexpr double infinity = std::numeric_limits<double>::infinity();

double largest_u(const Scene& scene)
{
  return radiusLimit(scene, ContactPlan{}).largest_u;
}

struct Playground
{
  std::size_t triangles;
  double unitsPerMillimetre;
};

class UpToTheLargestRadius : public ::testing::TestWithParam<Playground>
{
};

TEST_P(UpToTheLargestRadius, NoTickOfARandomHandRunsOutOfItsWorkOnEitherSide)
{
  const NoisySphere sphere(GetParam().triangles, GetParam().unitsPerMillimetre);
  const double limit_u = largest_u(*sceneOf(sphere.mesh()));
  ASSERT_TRUE(std::isfinite(limit_u));
  for (const double share : { 1.0, 0.9 })
  {
    for (const bool inside : { false, true })
    {
      const std::size_t ticks = testCount(10000);
      ContactPlan plan;
      plan.radius_u = share * limit_u;
      const SpherePlay seen = playOn(sphere, { plan, inside, ticks, testSeed(71) });
      EXPECT_EQ(seen.overBudget, 0u) << share << " of the limit, " << (inside ? "inside" : "outside");
      EXPECT_GT(seen.touching, ticks / 2) << "the hand played beside the surface";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Spheres, UpToTheLargestRadius,
  ::testing::Values(Playground{ 1000, 1.0 }, Playground{ 2000, 1e-3 }, Playground{ 5000, 1.0 },
    Playground{ 20000, 1e-3 }, Playground{ 100000, 1.0 }));

TEST(RadiusLimit, FarAboveItTicksDoRunOutOfTheirWork)
{
  const NoisySphere sphere(100000, 1.0);
  const auto scene = sceneOf(sphere.mesh());
  ContactPlan plan = fewPasses();
  ASSERT_EQ(radiusLimit(*scene, plan).largest_u, largest_u(*scene));
  plan.radius_u = 1.05 * radiusOfOneSweep_u(*scene, plan);
  ASSERT_LT(plan.radius_u, 0.9 * sphere_mm) << "it does not fit into the sphere";
  EXPECT_GT(playOn(sphere, { plan, true, testCount(2000), testSeed(71) }).overBudget, 0u);
}

TEST(RadiusLimit, IsALengthAndScalesWithTheScene)
{
  const TriangleMesh mesh = NoisySphere(10000, 1.0).mesh();
  const double one = largest_u(*sceneOf(mesh));
  for (const double factor : { 1e-3, 1e3 })
  {
    const double limit_u = largest_u(*sceneOf(scaled(mesh, factor)));
    EXPECT_NEAR(limit_u / factor, one, 1e-6 * one);
  }
}

TEST(RadiusLimit, OfASurfaceThatIsPosedIsThatOfTheSurface)
{
  const auto still = sceneOf(NoisySphere(10000, 1.0).mesh());
  Surface posed = still->surfaces().front();
  const Pose pose{ { 70.0, -20.0, 5.0 }, Quat(Eigen::AngleAxisd(1.0, Vec3(1.0, 2.0, 2.0) / 3.0)) };
  posed.motion = { pose, pose };
  const double limit_u = largest_u(*still);
  EXPECT_NEAR(largest_u(Scene(2, { posed })), limit_u, 1e-6 * limit_u);
}

TEST(RadiusLimit, OfTrianglesThatAllFitInATickIsNone)
{
  EXPECT_EQ(largest_u(Scene()), infinity);
  EXPECT_EQ(largest_u(*sceneOf(makeBox(Vec3::Zero(), Vec3::Ones()))), infinity);
}

TEST(RadiusLimit, GrowsWithTheBudgetAndFallsWithThePasses)
{
  const auto scene = sceneOf(NoisySphere(20000, 1.0).mesh());
  ContactPlan more, longer, nothing, endless;
  more.workBudget *= 2;
  longer.passCap *= 2;
  nothing.workBudget = 1;
  endless.passCap = 1U << 30; // times the sweeps of a pass it is more than 32 bits hold
  const double usual_u = largest_u(*scene);
  EXPECT_GT(radiusLimit(*scene, more).largest_u, usual_u);
  EXPECT_LT(radiusLimit(*scene, longer).largest_u, usual_u);
  EXPECT_EQ(radiusLimit(*scene, nothing).largest_u, 0.0);
  EXPECT_EQ(radiusLimit(*scene, endless).largest_u, 0.0);
}

TEST(RadiusLimit, OnAPlaneIsANumberOfEdges)
{
  // On a plane only r / edge says how many boxes a ball reaches; how the boxes happen to lie is worth a tenth.
  Random random(testSeed(72));
  const auto limitWith = [&random](int cells) {
    return largest_u(*sceneOf(makeSheet({ 1.0, 1.0, cells, cells, 0.0 }, random)));
  };
  EXPECT_NEAR(limitWith(256) / limitWith(128), 0.5, 0.1);
}

TEST(RadiusLimit, SaysWhetherTheAskedBallFits)
{
  const auto scene = sceneOf(NoisySphere(20000, 1.0).mesh());
  ContactPlan plan;
  plan.radius_u = 1.0;
  EXPECT_TRUE(radiusLimit(*scene, plan).kept());
  EXPECT_NE(radiusLimit(*scene, plan).sentence().find("finishes its work"), std::string::npos);
  plan.radius_u = 40.0;
  EXPECT_FALSE(radiusLimit(*scene, plan).kept());
  EXPECT_NE(radiusLimit(*scene, plan).sentence().find("only as far as is proven free"), std::string::npos);
}

} // namespace
} // namespace palpate::test
