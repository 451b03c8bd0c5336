// SPDX-License-Identifier: GPL-3.0-or-later
// Rows 32, 33: a tool never passes through anything, judged in exact arithmetic at the end of each step and within it.
#include <gtest/gtest.h>

#include <cstdlib>
#include <numbers>

#include "Tools.h"
#include "testing/support/NoisySphere.h"

namespace palpate::test
{
namespace
{

constexpr int inside = 8;

bool full()
{
  return std::getenv("PALPATE_TEST_FULL") != nullptr;
}

} // namespace

TEST(Passing, ABarOf200MillimetresSwungThroughAPostAtRandomIsHeldRow32)
{
  Random random(testSeed(3201));
  const TriangleMesh bar = makeBox(Vec3(-100, -0.5, -0.5), Vec3(100, 0.5, 0.5));
  const TriangleMesh post = makeBox(Vec3(-0.5, -0.5, -50), Vec3(0.5, 0.5, 50));
  JudgedTool judged(bar, post, inside);
  const std::size_t screws = testCount(full() ? 1000 : 40);
  std::size_t touching = 0;
  for (std::size_t i = 0; i < screws; ++i)
  {
    const Vec3 start(random.uniform(-80, 80), random.uniform(2, 20), random.uniform(-30, 30));
    ASSERT_EQ(judged.move.place({ start, Quat::Identity() }), "");
    const Vec3 way = 25.0 * random.direction(),
               axis = random.direction(); // 5 m/s and a quarter turn in 5 ms of updates
    for (int k = 1; k <= 10; ++k)
    {
      const double s = k / 10.0;
      judged.move.update({ start + s * way, turnBy(s * std::numbers::pi / 2.0 * axis) }, plenty);
    }
    touching += judged.move.rows().empty() ? 0 : 1;
  }
  EXPECT_EQ(judged.judge.found(), 0u) << "of " << judged.judge.judged();
  EXPECT_GT(touching, screws / 10);
}

TEST(Passing, ShotsAtASheetFromBothSidesStayOnTheirSideRow33)
{
  Random random(testSeed(3301));
  TriangleMesh sheet = makeSheet({ 100.0, 100.0, 12, 12, 0.3 }, random);
  for (Vec3& v : sheet.vertices_W)
  {
    v.z() = std::abs(v.x()) < 45.0 && std::abs(v.y()) < 45.0 ? random.uniform(-2.0, 2.0) : 0.0;
  }
  TriangleMesh blob = makeIcosphere(1, 8.0);
  for (Vec3& v : blob.vertices_W)
  {
    v *= random.uniform(0.6, 1.0);
  }
  JudgedTool judged(blob, sheet, inside);
  const std::size_t shots = testCount(full() ? 2000 : 40);
  std::size_t onItsSide = 0;
  for (std::size_t i = 0; i < shots; ++i)
  {
    const double side = i % 2 == 0 ? 1.0 : -1.0;
    const Vec3 start(random.uniform(-25, 25), random.uniform(-25, 25), 15.0 * side);
    ASSERT_EQ(judged.move.place({ start, turnBy(3.0 * random.uniform() * random.direction()) }), "");
    const Vec3 aim(start.x() + random.uniform(-5, 5), start.y() + random.uniform(-5, 5), -30.0 * side);
    const Quat turned = turnBy(3.0 * random.uniform() * random.direction());
    judged.move.update({ aim, turned }, plenty);
    judged.move.update({ aim, turned }, plenty);
    onItsSide += judged.move.pose_W().p.z() * side > -8.0 ? 1 : 0;
  }
  EXPECT_EQ(judged.judge.found(), 0u) << "of " << judged.judge.judged();
  EXPECT_EQ(onItsSide, shots);
}

TEST(Passing, AMeshThatWandersOverANoisySphereMeetsNothingRow33)
{
  Random random(testSeed(3302));
  const TriangleMesh noisy = NoisySphere(2000, 1.0).mesh();
  JudgedTool judged(scaled(NoisySphere(500, 1.0).mesh(), 0.4), noisy, inside);
  ASSERT_EQ(judged.move.place({ Vec3(90, 0, 0), Quat::Identity() }), "");
  const std::size_t touching = wander(judged, random, testCount(full() ? 5000 : 150), 65.0, plenty);
  EXPECT_EQ(judged.judge.found(), 0u) << "of " << judged.judge.judged();
  EXPECT_GT(touching, 10u);
}

TEST(Passing, OutOfWorkAnywhereThePoseIsFreeRow33)
{
  Random random(testSeed(3303));
  std::size_t touching = 0;
  for (const std::uint64_t work : { 50u, 400u, 3000u })
  {
    JudgedTool judged(scaled(NoisySphere(500, 1.0).mesh(), 0.4), NoisySphere(2000, 1.0).mesh(), inside);
    ASSERT_EQ(judged.move.place({ Vec3(90, 0, 0), Quat::Identity() }), "");
    touching += wander(judged, random, testCount(full() ? 5000 : 150), 65.0, work);
    EXPECT_EQ(judged.judge.found(), 0u) << "of " << judged.judge.judged();
    EXPECT_GT(judged.judge.judged(), 0u) << "it moves with " << work << " units of work";
  }
  EXPECT_GT(touching, 10u);
}

TEST(Passing, InASoupOfCrossingTrianglesMeetsNothing)
{
  Random random(testSeed(3304));
  JudgedTool judged(makeSoup(12, 6.0, random), makeSoup(60, 60.0, random), inside);
  Pose start{ Vec3(0, 0, 90), Quat::Identity() };
  ASSERT_EQ(judged.move.place(start), "");
  EXPECT_GT(wander(judged, random, testCount(full() ? 5000 : 150), 50.0, plenty), 10u);
  EXPECT_EQ(judged.judge.found(), 0u) << "of " << judged.judge.judged();
}

TEST(Passing, GoesTheSameWayTwiceBitForBit)
{
  const auto run = []
  {
    Random random(testSeed(3305));
    JudgedTool judged(makeIcosphere(1, 8.0), NoisySphere(2000, 1.0).mesh(), 0);
    judged.judge.sparse(1u << 20);
    EXPECT_EQ(judged.move.place({ Vec3(90, 0, 0), Quat::Identity() }), "");
    EXPECT_GT(wander(judged, random, 100, 65.0, 2000), 0u);
    return judged.move.pose_W();
  };
  const Pose one = run(), two = run();
  EXPECT_EQ(one.p, two.p);
  EXPECT_EQ(one.q.coeffs(), two.q.coeffs());
}

TEST(Passing, AToolThatStandsInSomethingIsNotPlaced)
{
  JudgedTool judged(makeBox(Vec3::Constant(-1), Vec3::Constant(1)), makeBox(Vec3::Constant(0), Vec3::Constant(5)), 0);
  EXPECT_NE(judged.move.place({ Vec3::Constant(0.2), Quat::Identity() }), "");
  EXPECT_EQ(judged.move.place({ Vec3::Constant(2.5), Quat::Identity() }), ""); // all of it inside, and free there
}

} // namespace palpate::test
