// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of faces that are kept while surfaces bend, against ticks that know none: the same answer to the last bit.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/contact/carry/PassingTriangles.h"
#include "haptics/contact/sweep/KeptFaces.h"
#include "haptics/contact/sweep/Neighbourhood.h"
#include "haptics/contact/view/SceneView.h"
#include "haptics/geometry/mesh/NearestOnTriangle.h"
#include "testing/support/Bender.h"
#include "testing/support/Curves.h"
#include "testing/support/Meshes.h"
#include "testing/support/NoisySphere.h"
#include "testing/support/Random.h"
#include "testing/support/RandomHand.h"

namespace palpate::test
{
namespace
{

/// A bending surface and its hand, a time at which snapshots come, and a body that stands beside the surface.
struct Bent
{
  TriangleMesh mesh;
  Bender::Path path;
  int ticksPerSnapshot = 20;
  double depth_u = 2e-3, radius_u = 1e-3;
  std::vector<TriangleMesh> standing = {};
  std::function<Pose(double)> pose_WS = {};
  std::optional<double> lineRadius_u = {};
  bool cutShort = false;
  bool turns = false; ///< its frame does, so that no list holds for longer than a tick
};

/// One of two runs of the same.
struct Run
{
  Run(const Bent& bent, const ContactPlan& plan) : bender(bent.mesh, bent.path, bent.ticksPerSnapshot)
  {
    this->bender.lineRadius_u = bent.lineRadius_u;
    this->bender.path_WS = bent.pose_WS;
    this->bender.frame = 1;
    this->bender.parameters.contact = plan;
    for (const TriangleMesh& mesh : bent.standing)
    {
      this->bender.addStanding(mesh);
    }
  }
  [[nodiscard]] const GodObjectState& ball() const { return this->bender.state.contact; }

  Bender bender;
};

void expectSame(const TickOutput& a, const TickOutput& b, const Run& keeping, const Run& forgetting, int tick)
{
  const auto numbers = [](const TickOutput& out)
  {
    const HapticState& s = out.state;
    return std::tie(s.contacts, s.passes, s.sweeps, s.friction, s.capped, s.overBudget, s.infeasible, s.pinned);
  };
  ASSERT_EQ(a.state.proxy_W.p, b.state.proxy_W.p) << "tick " << tick;
  ASSERT_EQ(a.state.force_D, b.state.force_D) << "tick " << tick;
  ASSERT_EQ(numbers(a), numbers(b)) << "tick " << tick;
  ASSERT_EQ(keeping.ball().count, forgetting.ball().count) << "tick " << tick;
  for (int i = 0; i < keeping.ball().count; ++i)
  {
    const auto at = static_cast<std::size_t>(i);
    ASSERT_EQ(keeping.ball().features[at], forgetting.ball().features[at]) << "tick " << tick;
  }
}

/// Returns how many of so many ticks began with a list that holds while the surface bends.
int compare(const Bent& bent, const ContactPlan& plan, std::uint64_t seed, int ticks)
{
  Run keeping(bent, plan), forgetting(bent, plan);
  const Pose pose_WS = bent.pose_WS ? bent.pose_WS(0.0) : Pose{};
  const TriangleMesh mesh_W = shifted(rotated(bent.mesh, pose_WS.q), pose_WS.p);
  RandomHand hand(mesh_W, bent.depth_u, seed);
  int listed = 0;
  for (int i = 0; i < ticks && !testing::Test::HasFatalFailure(); ++i)
  {
    if (bent.cutShort && i % 23 == 11)
    {
      keeping.bender.cutShort();
      forgetting.bender.cutShort();
    }
    const FacesAround& around = keeping.ball().around;
    listed += around.bends() && around.far.count() > 0 ? 1 : 0;
    forgetting.bender.state.contact.around = FacesAround{};
    const Vec3 p_W = hand.next();
    const TickOutput a = keeping.bender.tick(p_W), b = forgetting.bender.tick(p_W);
    expectSame(a, b, keeping, forgetting, i);
  }
  return listed;
}

/// A list is made in the second tick of a snapshot at the earliest and kept until the first one of the next: so all
/// ticks but one of each snapshot may begin with it, and at least a tenth of those must, by each plan.
void expectTheSame(const Bent& bent, int seed)
{
  const auto ticks = static_cast<int>(testCount(600));
  const int most = ticks - ticks / bent.ticksPerSnapshot;
  for (const double radius : { bent.radius_u, 0.0 })
  {
    ContactPlan plain, friction, shading;
    plain.radius_u = friction.radius_u = shading.radius_u = radius;
    friction.friction = { 0.5, 0.4 };
    shading.shading = true;
    for (const ContactPlan& plan : { plain, friction, shading })
    {
      const int listed = compare(bent, plan, testSeed(static_cast<std::uint64_t>(seed)), ticks);
      SCOPED_TRACE(testing::Message() << "radius " << radius << ", shading " << plan.shading << ", friction "
                                      << plan.friction.kinetic);
      EXPECT_LE(listed, bent.turns ? 0 : most);
      EXPECT_GE(listed, bent.turns ? 0 : most / 10) << "lists are kept too rarely to compare anything";
    }
  }
}

TriangleMesh sphere(std::size_t triangles)
{
  return scaled(NoisySphere(triangles, 1.0).mesh(), 1e-3);
}

Vec3 swelling(const Vec3& v, double t_s)
{
  return (1.0 + 0.03 * std::sin(40.0 * t_s)) * v;
}

Vec3 waving(const Vec3& v, double t_s)
{
  return v + Vec3(0, 0, 2e-3 * std::sin(200.0 * v.x() - 12.0 * t_s));
}

TEST(KeptWhileBending, ChangeNoBitOnASphereThatSwells)
{
  expectTheSame({ sphere(20000), swelling }, 821);
}

TEST(KeptWhileBending, ChangeNoBitOnWavesOfARoughOne)
{
  Random random(testSeed(822));
  TriangleMesh rough = sphere(20000);
  for (Vec3& v : rough.vertices_W)
  {
    v *= 1.0 + 4e-3 * random.uniform(-1.0, 1.0);
  }
  expectTheSame({ .mesh = rough, .path = waving, .cutShort = true }, 823);
}

TEST(KeptWhileBending, ChangeNoBitOnLargeTrianglesAndInASoup)
{
  Random random(testSeed(824));
  expectTheSame({ .mesh = sphere(500), .path = waving, .ticksPerSnapshot = 50, .radius_u = 5e-3 }, 825);
  expectTheSame({ .mesh = makeSoup(300, 0.02, random), .path = waving, .depth_u = 1e-3, .radius_u = 5e-4 }, 826);
}

TEST(KeptWhileBending, ChangeNoBitBesideSurfacesThatStand)
{
  const std::vector<TriangleMesh> beside = { shifted(sphere(5000), { 0.03, 0, 0 }), sphere(500) };
  expectTheSame({ .mesh = sphere(5000), .path = swelling, .standing = beside }, 827);
}

TEST(KeptWhileBending, ChangeNoBitInAPoseAndWhereItsFrameMoves)
{
  const auto posed = [](double) { return Pose{ Vec3(0.01, 0.02, 0), Quat(Eigen::AngleAxisd(0.7, Vec3::UnitX())) }; };
  const auto turning = [](double t_s) {
    return Pose{ Vec3(0.02 * t_s, 0, 0), Quat(Eigen::AngleAxisd(t_s, Vec3::UnitZ())) };
  };
  Bent bent{ .mesh = sphere(5000), .path = swelling, .depth_u = 0.02 };
  bent.pose_WS = posed;
  expectTheSame(bent, 828);
  bent.pose_WS = turning;
  bent.turns = true;
  expectTheSame(bent, 829);
}

TEST(KeptWhileBending, ChangeNoBitOnCurves)
{
  Random random(testSeed(830));
  TriangleMesh lines;
  for (std::uint32_t i = 0; i < 600; ++i)
  {
    lines.vertices_W.push_back(0.02 * Vec3(std::cos(0.1 * i), std::sin(0.1 * i), 2e-3 * i - 0.6) + random.inCube(3e-4));
    if (i > 0)
    {
      lines.triangles.push_back({ i - 1, i, i });
    }
  }
  expectTheSame({ .mesh = lines, .path = waving, .lineRadius_u = 5e-4 }, 831);
}

/// Ticks of a ball on a sphere that swells, in snapshots of so many ticks.
Run onSwellingSphere(int ticksPerSnapshot)
{
  ContactPlan plan;
  plan.radius_u = 1e-3;
  return Run({ .mesh = sphere(20000), .path = swelling, .ticksPerSnapshot = ticksPerSnapshot }, plan);
}

TEST(KeptWhileBending, TheListOfASnapshotIsMadeInItsSecondTickHoweverLongTheFirstTook)
{
  constexpr int ticksPerSnapshot = 20, snapshots = 40;
  auto run = onSwellingSphere(ticksPerSnapshot);
  int longFirst = 0, shortSecond = 0;
  for (int i = 0; i < snapshots * ticksPerSnapshot; ++i)
  {
    const int tick = i % ticksPerSnapshot, snapshot = i / ticksPerSnapshot;
    const double x_m = (snapshot % 2 == 0 ? 3e-3 : -3e-3) + 5e-5 * tick; // a jump in each first tick, and then a slide
    run.bender.state.contact.around.pause = 0;                           // whatever use the lists before were of
    const HapticState felt = run.bender.tick({ x_m, 0, snapshot == 0 ? 0.06 : 0.047 }).state;
    const bool isShort = felt.passes <= 4 && felt.sweeps <= 3;
    if (snapshot > 0 && tick == 0)
    {
      ASSERT_EQ(run.ball().around.far.count(), 0) << "the tick that takes a snapshot makes a list, too: " << i;
      longFirst += isShort ? 0 : 1;
    }
    if (snapshot > 0 && tick == 1 && isShort)
    {
      ASSERT_GT(run.ball().around.far.count(), 0) << "snapshot " << snapshot;
      ++shortSecond;
    }
  }
  EXPECT_GT(longFirst, snapshots / 2);
  EXPECT_GT(shortSecond, snapshots / 2);
}

TEST(KeptWhileBending, ListsThatDieYoungWithTheirSnapshotsAreTriedMoreAndMoreRarely)
{
  constexpr int ticksPerSnapshot = 3, ticks = 900; // a list of the second tick serves the third one, then dies
  auto run = onSwellingSphere(ticksPerSnapshot);
  int made = 0;
  Vec3 last_W = Vec3::Zero();
  for (int i = 0; i < ticks; ++i)
  {
    run.bender.tick({ 1e-6 * i, 0, i == 0 ? 0.06 : 0.047 });
    const FaceList& far = run.ball().around.far;
    made += far.count() > 0 && far.reach().centre_W != last_W ? 1 : 0;
    last_W = far.count() > 0 ? far.reach().centre_W : last_W;
  }
  // Pauses of 1, 3, 7, 15 and then always 31 ticks, of those that are not the first of a snapshot.
  constexpr int mayTry = ticks * (ticksPerSnapshot - 1) / ticksPerSnapshot;
  EXPECT_LE(made, 5 + mayTry / 32);
  EXPECT_GE(made, 5);
}

TEST(KeptWhileBending, AListHoldsEveryFaceWithinItsReachToTheEndOfTheWay)
{
  Bender bender(sphere(2000), waving, 50);
  Random random(testSeed(832));
  for (std::size_t i = 0; i < testCount(100); ++i)
  {
    const double since = random.uniform();
    static_cast<void>(bender.tick({ 0, 0, 0.1 }));
    const Scene& scene = *bender.scene();
    const Reach reach{ 0.05 * random.direction() + random.inCube(2e-3), random.uniform(5e-4, 5e-3) };
    Resolution resolution;
    resolution.include(Vec3::Constant(0.06));
    std::uint32_t nodes = 0;
    FaceList list;
    ASSERT_TRUE(gatherFaces(
      MovingScene(scene, since), Moments::ToTheEnd, reach, resolution, FaceList::capacity, 100000, nodes, list));
    std::vector<bool> listed(scene.surfaces()[0].tree->mesh().triangles.size());
    for (int k = 0; k < list.count(); ++k)
    {
      listed[list.face(k).triangle] = true;
    }
    for (const double share : { since, random.uniform(since, 1.0), random.uniform(since, 1.0), 1.0 })
    {
      const PosedSurface surface = surfaceOf(MovingScene(scene, share), 0);
      for (std::uint32_t t = 0; t < listed.size(); ++t)
      {
        const auto [a, b, c] = surface.cornersOf(t);
        const double distance_u = (nearestOnTriangle(reach.centre_W, a, b, c) - reach.centre_W).norm();
        ASSERT_TRUE(listed[t] || distance_u > reach.reach_u) << "face " << t << " at " << share;
      }
    }
  }
}

/// The centroid of a triangle, and how far its corners are from there.
struct TriangleBall
{
  explicit TriangleBall(const std::array<Vec3, 3>& corners) : centre_W((corners[0] + corners[1] + corners[2]) / 3.0)
  {
    for (const Vec3& corner : corners)
    {
      this->radius_u = std::max(this->radius_u, (corner - this->centre_W).norm());
    }
  }

  Vec3 centre_W;
  double radius_u = 0.0;
};

TEST(KeptWhileBending, AListIsPickedOfAllFacesThatAreNearAtItsMomentAndOfNoneWhoseBallIsNot)
{
  Bender bender(sphere(2000), waving, 50);
  Random random(testSeed(833));
  int passedOver = 0; // near at another moment
  for (std::size_t i = 0; i < testCount(100); ++i)
  {
    static_cast<void>(bender.tick({ 0, 0, 0.1 }));
    const Scene& scene = *bender.scene();
    FacesAround around;
    around.content = scene.contentHash();
    around.since = random.uniform();
    Resolution resolution;
    resolution.include(Vec3::Constant(0.06));
    const Reach reach{ 0.05 * random.direction() + random.inCube(2e-3), random.uniform(2e-3, 8e-3) };
    std::uint32_t nodes = 0;
    const MovingScene begin(scene, around.since);
    ASSERT_TRUE(
      gatherFaces(begin, Moments::ToTheEnd, reach, resolution, FaceList::capacity, 100000, nodes, around.far));
    const double share = random.uniform(around.since, 1.0);
    const MovingScene now(scene, share);
    pickAround(now, reach.centre_W, 0.5 * reach.reach_u, around);
    const Reach& picked = around.near.reach();
    ASSERT_GT(picked.reach_u, 0.5 * reach.reach_u);
    std::vector<bool> listed(scene.surfaces()[0].tree->mesh().triangles.size());
    for (int k = 0; k < around.near.count(); ++k)
    {
      listed[around.near.face(k).triangle] = true;
    }
    for (std::uint32_t t = 0; t < listed.size(); ++t)
    {
      const std::array<Vec3, 3> corners = surfaceOf(now, 0).cornersOf(t);
      const auto [a, b, c] = corners;
      const double distance_u = (nearestOnTriangle(picked.centre_W, a, b, c) - picked.centre_W).norm();
      ASSERT_TRUE(listed[t] || distance_u > picked.reach_u) << "face " << t << " at " << share;
      // The ball that goes with a face is as large as at the end at which the face is larger.
      const double radius_u = std::max(TriangleBall(surfaceOf(begin, 0).cornersOf(t)).radius_u,
        TriangleBall(surfaceOf(MovingScene(scene, 1.0), 0).cornersOf(t)).radius_u);
      const double away_u = (TriangleBall(corners).centre_W - picked.centre_W).norm();
      ASSERT_TRUE(!listed[t] || away_u <= 1.001 * (picked.reach_u + radius_u)) << "face " << t << " at " << share;
    }
    for (int k = 0; k < around.far.count(); ++k)
    {
      passedOver += listed[around.far.face(k).triangle] ? 0 : 1;
    }
  }
  EXPECT_GT(passedOver, 0);
}

TEST(PassingTriangles, TheNearestOfAListComesWithAllThatAreAboutAsNear)
{
  Bender bender(sphere(2000), waving, 50);
  static_cast<void>(bender.tick({ 0, 0, 0.1 }));
  const Scene& scene = *bender.scene();
  const MovingScene from(scene, 0.3), to(scene, 0.4);
  const PosedSurface before = surfaceOf(from, 0), now = surfaceOf(to, 0);
  const TriangleMesh& mesh = scene.surfaces()[0].tree->mesh();
  Random random(testSeed(834));
  std::array<int, 4> met{}; // over faces, edges, vertices, and beside edges
  for (std::size_t i = 0; i < testCount(600); ++i)
  {
    // A ball that touches a face, at its border or so near to it that the next face is hardly further away.
    const auto face = static_cast<std::uint32_t>(random.uniform(0.0, static_cast<double>(mesh.triangles.size())));
    const auto [a, b, c] = before.cornersOf(face);
    const Vec3 middle = (a + b + c) / 3.0, edge = 0.5 * (a + b);
    const std::array<Vec3, 4> places{ middle, edge, a, edge + 1e-4 * (middle - edge) };
    const std::size_t kind = i % places.size();
    const double radius_u = random.uniform(3e-4, 1e-3);
    const Vec3 x_W = places[kind] + radius_u * before.face(face).normal_W;
    Resolution resolution;
    resolution.include(x_W);
    FaceList list;
    std::uint32_t nodes = 0;
    ASSERT_TRUE(gatherFaces(from, Moments::Now, { x_W, 2e-2 }, resolution, FaceList::capacity, 100000, nodes, list));
    PassingTriangles passing(before, now, x_W, x_W, 1.1 * radius_u, 100000);
    const auto nearest = passing.nearestIn(list, 0, x_W, resolution.tol());
    std::vector<double> distances2;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    {
      const auto [p, q, r] = before.cornersOf(t);
      distances2.push_back((nearestOnTriangle(x_W, p, q, r) - x_W).squaredNorm());
    }
    const auto least = std::ranges::min_element(distances2);
    ASSERT_TRUE(nearest && distances2[*nearest] == *least);
    std::vector<std::uint32_t> alike(passing.alike().begin(), passing.alike().end()), truth;
    std::ranges::sort(alike);
    for (std::uint32_t t = 0; t < distances2.size(); ++t)
    {
      if (distances2[t] <= (1.0 + 2e-6) * *least) // all that a way can meet which is a millionth longer
      {
        ASSERT_TRUE(std::ranges::binary_search(alike, t)) << "triangle " << t << ", place " << kind;
        truth.push_back(t);
      }
    }
    met[kind] += truth.size() > (kind == 0 ? 0 : 1) ? 1 : 0;
  }
  EXPECT_GT(*std::ranges::min_element(met), 0);
}

TEST(FaceCache, GivesTheFaceOfThatSurfaceAndTriangleHoweverManyThereAre)
{
  Random random(testSeed(641));
  FaceCache cache;
  for (std::size_t i = 0; i < testCount(10000); ++i)
  {
    const auto surface = static_cast<std::uint32_t>(random.uniform(0.0, 4.0)),
               triangle = static_cast<std::uint32_t>(random.uniform(0.0, 300.0));
    const FaceRecord& face = cache.at(surface, triangle,
      [&]
      {
        FaceRecord computed{};
        computed.normal_W = Vec3(surface, triangle, 0.0);
        return computed;
      });
    ASSERT_EQ(face.normal_W, Vec3(surface, triangle, 0.0));
  }
}

TEST(FaceCache, HoldsFacesOnTheirWayAsTheyAreComputedWithoutIt)
{
  Random random(testSeed(642));
  Bender bender(sphere(2000), waving, 50);
  static_cast<void>(bender.tick({ 0, 0, 0.1 }));
  const auto triangles = static_cast<double>(bender.scene()->surfaces()[0].tree->mesh().triangles.size());
  FaceCache cache;
  const PosedSurface kept = surfaceOf(MovingScene(*bender.scene(), 0.3, &cache), 0),
                     anew = surfaceOf(MovingScene(*bender.scene(), 0.3), 0);
  for (std::size_t i = 0; i < testCount(10000); ++i)
  {
    const auto triangle = static_cast<std::uint32_t>(random.uniform(0.0, triangles));
    for (int again = 0; again < 2; ++again)
    {
      const FaceRecord a = kept.face(triangle), b = anew.face(triangle);
      ASSERT_EQ(
        std::tie(a.corner_W, a.normal_W, a.sliver, a.owned), std::tie(b.corner_W, b.normal_W, b.sliver, b.owned));
    }
  }
}

} // namespace
} // namespace palpate::test
