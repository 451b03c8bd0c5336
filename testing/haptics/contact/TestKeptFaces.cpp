// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of faces that are kept over ticks, against ticks that know none: the same answer to the last bit.
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/contact/GodObject.h"
#include "haptics/contact/sweep/KeptFaces.h"
#include "haptics/contact/sweep/Neighbourhood.h"
#include "haptics/geometry/mesh/NearestOnTriangle.h"
#include "haptics/geometry/scene/SceneBuilder.h"
#include "testing/support/Curves.h"
#include "testing/support/Meshes.h"
#include "testing/support/NoisySphere.h"
#include "testing/support/Random.h"
#include "testing/support/RandomHand.h"

namespace palpate::test
{
namespace
{

std::string differenceOf(const ContactResult& a, const ContactResult& b)
{
  const bool same = a.proxy_W == b.proxy_W && a.pull_W == b.pull_W && a.held_u2 == b.held_u2 &&
                    a.contacts == b.contacts && a.heldCount == b.heldCount && a.passes == b.passes &&
                    a.sweeps == b.sweeps && a.capped == b.capped && a.overBudget == b.overBudget &&
                    a.infeasible == b.infeasible && a.friction == b.friction;
  if (same)
  {
    return {};
  }
  return std::to_string((a.proxy_W - b.proxy_W).norm()) + " apart, passes " + std::to_string(a.passes) + " and " +
         std::to_string(b.passes) + ", sweeps " + std::to_string(a.sweeps) + " and " + std::to_string(b.sweeps);
}

/// Ticks of a hand over a scene, each of them by a ball that keeps its lists and by one that forgets them.
struct Pair
{
  const Scene& scene;
  ContactPlan plan;
  GodObjectState keeping{}, forgetting{};
  int listed = 0; ///< ticks that began with a list for the ticks to come

  std::string to(const Vec3& p_W)
  {
    this->listed += this->keeping.around.far.count() > 0 ? 1 : 0;
    this->forgetting.around = FacesAround{};
    const ContactResult a = moveGodObject(this->scene, this->plan, p_W, this->keeping);
    return differenceOf(a, moveGodObject(this->scene, this->plan, p_W, this->forgetting));
  }
};

std::vector<ContactPlan> plans(double radius_u)
{
  ContactPlan plain, friction, shading;
  plain.radius_u = friction.radius_u = shading.radius_u = radius_u;
  friction.friction = { 0.5, 0.4 };
  shading.shading = true;
  return { plain, friction, shading };
}

/// Runs a hand over a mesh by each plan; a point first, then a ball.
void expectTheSame(const Scene& scene, const TriangleMesh& mesh, double depth_u, double radius_u, std::uint64_t seed)
{
  int listed = 0;
  for (const double r : { 0.0, radius_u })
  {
    for (const ContactPlan& plan : plans(r))
    {
      RandomHand hand(mesh, depth_u, seed);
      Pair pair{ scene, plan };
      for (std::size_t i = 0; i < testCount(1500); ++i)
      {
        const std::string difference = pair.to(hand.next());
        ASSERT_EQ(difference, "") << "tick " << i << ", radius " << r << ", shading " << plan.shading << ", friction "
                                  << plan.friction.kinetic << ", seed " << seed;
      }
      listed += pair.listed;
    }
  }
  EXPECT_GT(listed, 500) << "no list was kept: nothing was compared";
}

TEST(KeptFaces, ChangeNoBitOnASmoothAndOnARoughMesh)
{
  const TriangleMesh fine = NoisySphere(20000, 1.0).mesh();
  expectTheSame(*sceneOf(fine), fine, 2.0, 1.0, testSeed(301));
  Random random(testSeed(302));
  TriangleMesh rough = NoisySphere(20000, 1.0).mesh();
  for (Vec3& v : rough.vertices_W)
  {
    v *= 1.0 + 0.004 * random.uniform(-1.0, 1.0);
  }
  expectTheSame(*sceneOf(rough), rough, 2.0, 1.0, testSeed(303));
}

TEST(KeptFaces, ChangeNoBitInASoupAndAmongManySurfaces)
{
  Random random(testSeed(304));
  const TriangleMesh soup = makeSoup(400, 20.0, random);
  expectTheSame(*sceneOf(soup), soup, 1.0, 0.5, testSeed(305));
  std::vector<SurfaceInput> inputs;
  for (int i = 0; i < 12; ++i)
  {
    auto part = std::make_shared<TriangleMesh>(shifted(makeIcosphere(3, 8.0), random.inCube(12.0)));
    inputs.push_back({ "part " + std::to_string(i), part, {} });
    inputs.back().pose_WS =
      Pose{ random.inCube(3.0), Quat(Eigen::AngleAxisd(random.uniform(0, 6), random.direction())) };
  }
  expectTheSame(*SceneBuilder().build(inputs).scene, *inputs.front().mesh, 2.0, 1.0, testSeed(306));
}

TEST(KeptFaces, ChangeNoBitAlongCurves)
{
  Random random(testSeed(307));
  const std::vector<Tubes> tubes = { wanderingTubes(20, 40, 15.0, 0.4, random) };
  const auto scene = sceneOf(tubes);
  for (const double r : { 0.0, 0.6 })
  {
    ContactPlan plan;
    plan.radius_u = r;
    TubeHand hand(tubes, 15.0, 0.5, testSeed(308));
    Pair pair{ *scene, plan };
    for (std::size_t i = 0; i < testCount(3000); ++i)
    {
      const std::string difference = pair.to(hand.next());
      ASSERT_EQ(difference, "") << "tick " << i << ", radius " << r;
    }
    EXPECT_GT(pair.listed, 500);
  }
}

TEST(KeptFaces, AreDroppedWithTheContentTheyAreOf)
{
  const TriangleMesh mesh = makeIcosphere(4, 50.0);
  const auto before = sceneOf(mesh), after = sceneOf(rotated(mesh, Quat(Eigen::AngleAxisd(0.7, Vec3::UnitX()))));
  ContactPlan plan;
  plan.radius_u = 1.0;
  GodObjectState state;
  (void)moveGodObject(*before, plan, { 0, 0, 60 }, state);
  for (int i = 0; i < 200; ++i)
  {
    (void)moveGodObject(*before, plan, { 0.02 * i, 0, 50 }, state);
  }
  ASSERT_GT(state.around.far.count(), 0);
  GodObjectState fresh = state;
  fresh.around = FacesAround{};
  for (int i = 200; i < 400; ++i)
  {
    const Vec3 p_W(0.02 * i, 0, 50);
    const ContactResult a = moveGodObject(*after, plan, p_W, state);
    const ContactResult b = moveGodObject(*after, plan, p_W, fresh);
    ASSERT_EQ(differenceOf(a, b), "") << "tick " << i;
  }
}

TEST(KeptFaces, AListHoldsEveryFaceWithinItsReach)
{
  Random random(testSeed(309));
  const auto scene = sceneOf(NoisySphere(5000, 1.0).mesh());
  const SurfaceData& data = scene->surfaces()[0].tree->data();
  for (std::size_t i = 0; i < testCount(200); ++i)
  {
    const Reach reach{ 50.0 * random.direction() + random.inCube(2.0), random.uniform(0.5, 5.0) };
    Resolution resolution;
    resolution.include(Vec3::Constant(60.0));
    std::uint32_t nodes = 0;
    FaceList list;
    ASSERT_TRUE(gatherFaces(*scene, Moments::Now, reach, resolution, FaceList::capacity, 100000, nodes, list));
    std::vector<bool> listed(data.faces.size());
    for (int k = 0; k < list.count(); ++k)
    {
      listed[list.face(k).triangle] = true;
    }
    for (std::uint32_t t = 0; t < data.faces.size(); ++t)
    {
      const auto& [a, b, c] = data.cornersOf(t);
      const double distance_u = (nearestOnTriangle(reach.centre_W, a, b, c) - reach.centre_W).norm();
      ASSERT_TRUE(listed[t] || distance_u > reach.reach_u) << "face " << t;
    }
  }
}

TEST(KeptFaces, AListThatIsTooLongForItsRoomIsEmptyAndSaysSo)
{
  const auto scene = sceneOf(NoisySphere(20000, 1.0).mesh());
  std::uint32_t nodes = 0;
  FaceList list;
  EXPECT_FALSE(gatherFaces(*scene, Moments::Now, { { 0, 0, 50 }, 40.0 }, {}, FaceList::capacity, 100000, nodes, list));
  EXPECT_EQ(list.count(), 0);
  EXPECT_FALSE(list.reach().covers(Reach{ { 0, 0, 50 }, 1.0 }));
}

} // namespace
} // namespace palpate::test
