// SPDX-License-Identifier: GPL-3.0-or-later
// Tools that are large or tight, in units of work: data that are kept between updates, and how rarely the work runs
// out.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "Tools.h"
#include "haptics/tool/worker/ToolFollower.h"
#include "testing/support/NoisySphere.h"
#include "testing/support/Thread.h"
#include "testing/support/WindingHand.h"

namespace palpate::test
{
namespace
{

/// A tool that moves at random among triangles, with its front, and all pairs of triangles to judge it by.
struct WatchedFront
{
  WatchedFront(const TriangleMesh& toolMesh, const TriangleMesh& sceneMesh)
    : tool(makeTool(toolMesh).value), scene_W(makeToolScene(cleanMesh(sceneMesh).mesh, tool)),
      front(*tool.shape_B, *scene_W, tool.restGap_u())
  {
  }

  /// The leaf of each triangle.
  static std::vector<std::uint32_t> leavesOf(const BoxedMesh& mesh)
  {
    std::vector<std::uint32_t> leaves(mesh.mesh().triangles.size());
    for (std::uint32_t node = 0; node < mesh.nodes().size(); ++node)
    {
      const BoxedMesh::Node& of = mesh.nodes()[node];
      for (std::uint32_t t = of.second; of.leaf() && t < of.second + of.count; ++t)
      {
        leaves[t] = node;
      }
    }
    return leaves;
  }

  void gather(double margin_u)
  {
    WorkBudget unlimited(std::numeric_limits<std::uint64_t>::max());
    ASSERT_TRUE(front.gather(pose_W, margin_u, unlimited));
  }

  void move(const Vec3& v, const Vec3& w)
  {
    const ScrewStep step{ pose_W, v, w };
    front.moved(step.displacement_u(tool.reach_u), w.norm());
    pose_W = step.end_W(1.0);
  }

  /// The least distance of two triangles whose leaves are not in the list, or the margin.
  [[nodiscard]] double nearestUnlisted_u() const
  {
    const std::vector<std::uint32_t> ofTool = leavesOf(*tool.shape_B), ofScene = leavesOf(*scene_W);
    std::set<std::pair<std::uint32_t, std::uint32_t>> listed;
    for (const BoxPair& pair : front.near())
    {
      listed.insert({ pair.tool, pair.scene });
    }
    double least_u = front.margin_u();
    for (std::uint32_t a = 0; a < ofTool.size(); ++a)
    {
      Corners tool_W = tool.shape_B->corners(a);
      for (Vec3& p : tool_W)
      {
        p = pose_W.p + pose_W.q * p;
      }
      for (std::uint32_t b = 0; b < ofScene.size(); ++b)
      {
        const Corners scene = scene_W->corners(b);
        if (boxesApart_u(tool_W, scene) < least_u && listed.count({ ofTool[a], ofScene[b] }) == 0)
        {
          least_u = std::min(least_u, nearestPair(tool_W, scene).distance_u);
        }
      }
    }
    return least_u;
  }

  /// Of two triangles.
  [[nodiscard]] double distance_u(std::uint32_t toolTriangle, std::uint32_t sceneTriangle) const
  {
    Corners tool_W = tool.shape_B->corners(toolTriangle);
    for (Vec3& p : tool_W)
    {
      p = pose_W.p + pose_W.q * p;
    }
    return nearestPair(tool_W, scene_W->corners(sceneTriangle)).distance_u;
  }

  /// Of the triangles of two leaves.
  [[nodiscard]] double distance_u(const LeafPair& pair) const
  {
    const BoxedMesh::Node &a = tool.shape_B->nodes()[pair.toolNode], &b = scene_W->nodes()[pair.sceneNode];
    double least_u = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = a.second; i < a.second + a.count; ++i)
    {
      for (std::uint32_t j = b.second; j < b.second + b.count; ++j)
      {
        least_u = std::min(least_u, distance_u(i, j));
      }
    }
    return least_u;
  }

  ToolMesh tool;
  std::shared_ptr<const BoxedMesh> scene_W;
  PairFront front;
  Pose pose_W;
};

constexpr double pitchOf240 = 2.0;

TriangleMesh nutOf240()
{
  return threadMesh({ 5.3, pitchOf240, 10.0 }, 240);
}

TriangleMesh screwOf240()
{
  return threadMesh({ 5.0, pitchOf240, 12.0 }, 240);
}

/// How many of 400 updates of a ball that winds around another run out of work.
int outOfWorkOf400(std::size_t toolTriangles, std::size_t sceneTriangles)
{
  const ToolMesh tool = makeTool(scaled(NoisySphere(toolTriangles, 1.0).mesh(), 0.3)).value;
  const auto scene_W = makeToolScene(cleanMesh(NoisySphere(sceneTriangles, 1.0).mesh()).mesh, tool);
  ToolMove move(tool, scene_W, tool.gyration_u);
  EXPECT_EQ(move.place({ Vec3(80.0, 0.0, 0.0), Quat::Identity() }), "");
  int spent = 0;
  for (int i = 0; i < 400; ++i)
  {
    spent += move.update(windingHand(1e-3 * i, 100.0), ToolFollower::workOf(tool, *scene_W)).spent ? 1 : 0;
  }
  return spent;
}

} // namespace

TEST(ToolWork, WhatIsNotInTheListIsFurtherAwayThanTheRoomHoweverTheToolMovedAndTurned)
{
  Random random(testSeed(3401));
  for (const double turn_rad : { 0.0, 0.02, 0.4 })
  {
    WatchedFront watched(scaled(NoisySphere(180, 1.0).mesh(), 0.4), NoisySphere(500, 1.0).mesh());
    watched.pose_W = { Vec3(72, 0, 0), Quat::Identity() };
    std::size_t listed = 0;
    for (int i = 0; i < 60; ++i)
    {
      const double margin_u = random.uniform(0.2, 4.0);
      watched.gather(margin_u);
      EXPECT_GE(watched.nearestUnlisted_u(), watched.front.margin_u());
      listed += watched.front.near().size();
      const Vec3 home = (Vec3(72, 0, 0) - watched.pose_W.p) * 0.2;
      watched.move(home + random.uniform(0.0, 1.5) * random.direction(), turn_rad * random.direction());
    }
    EXPECT_GT(listed, 0u);
  }
}

TEST(ToolWork, ANutFollowsItsScrewAtOneTurnASecondToWithinItsPlay)
{
  constexpr int around = 16;
  constexpr double pitch = 2.0, lead = pitch / (2.0 * std::numbers::pi), play = 0.3;
  const ThreadSize screw{ 5.0, pitch, 12.0 }, bore{ 5.0 + play, pitch, 6.0 };
  JudgedTool judged(threadMesh(bore, around), threadMesh(screw, around), 0);
  judged.judge.sparse(100);
  const Pose start_W{ judged.tool.centre_W, Quat::Identity() };
  ASSERT_EQ(judged.move.place(start_W), "");
  int spent = 0, touching = 0;
  constexpr int updates = 500;
  double turned = 0.0, mostPlay = 0.0, mostBehind = 0.0;
  for (int i = 1; i <= updates; ++i)
  {
    const double turn = 2.0 * std::numbers::pi * 1e-3 * i; // one turn a second
    const double pulled = std::min(0.4, 0.004 * i);        // further than its play
    const Pose hand_W{ start_W.p + Vec3(0, 0, lead * turn + pulled), Quat(Eigen::AngleAxisd(turn, Vec3::UnitZ())) };
    spent += judged.move.update(hand_W, ToolFollower::usualWork).spent ? 1 : 0;
    touching += judged.move.rows().empty() ? 0 : 1;
    const Pose& at_W = judged.move.pose_W();
    const double step = (at_W.q * Quat(Eigen::AngleAxisd(-turned, Vec3::UnitZ()))).vec().z();
    turned += 2.0 * std::asin(std::clamp(step, -1.0, 1.0));
    // Along its thread a nut has its play; more only between chords.
    const double chord = 6.3 * (1.0 - std::cos(std::numbers::pi / around));
    mostPlay = std::max(mostPlay, std::abs(at_W.p.z() - start_W.p.z() - lead * turned) - 2.0 * chord);
    mostBehind = std::max(mostBehind, std::abs(turn - turned));
  }
  EXPECT_LE(mostPlay, play);
  EXPECT_LE(mostBehind, play / lead);
  EXPECT_LE(spent, updates / 6);
  EXPECT_GT(touching, updates / 2);
  EXPECT_EQ(judged.judge.found(), 0u) << "of " << judged.judge.judged();
}

TEST(ToolWork, ANutThatFindsNoStepWithTheWorkOfAnUpdateGoesOnWithThatOfLaterOnes)
{
  constexpr int around = 64;
  constexpr double pitch = 2.0, lead = pitch / (2.0 * std::numbers::pi), play = 0.3;
  JudgedTool judged(threadMesh({ 5.0 + play, pitch, 6.0 }, around), threadMesh({ 5.0, pitch, 12.0 }, around), 0);
  const Pose start_W{ judged.tool.centre_W, Quat::Identity() };
  ASSERT_EQ(judged.move.place(start_W), "");
  constexpr double turn = 0.2;
  const Pose hand_W{ start_W.p + Vec3(0, 0, lead * turn + 2.0 * play), turnBy(Vec3(0, 0, turn)) };
  const auto left = [&] { return turnFromTo(judged.move.pose_W().q, hand_W.q).norm(); };
  int standing = 0, longest = 0;
  double last = left();
  for (int i = 0; i < 400 && left() > 0.05; ++i)
  {
    static_cast<void>(judged.move.update(hand_W, ToolFollower::usualWork / 16));
    // At first it finds all that is near, in many updates, whatever it can do later with the work of one.
    standing = left() == last && left() < 0.9 * turn ? standing + 1 : 0;
    longest = std::max(longest, standing);
    last = left();
  }
  EXPECT_LE(left(), 0.05);
  EXPECT_LE(longest, 12) << "updates without any turn, one after the other";
  EXPECT_EQ(judged.judge.found(), 0u) << "of " << judged.judge.judged();
}

TEST(ToolWork, WhatAnUpdateDidBeyondItsWorkIsPaidByThoseAfterIt)
{
  const TriangleMesh cube = makeBox(Vec3::Constant(-0.5), Vec3::Constant(0.5));
  JudgedTool judged(cube, shifted(cube, Vec3(0, 0, 1.01)), 0);
  ASSERT_EQ(judged.move.place({}), "");
  const Pose hand_W{ Vec3(0.01, 0.0, 0.1), Quat::Identity() };
  ASSERT_TRUE(settle(judged.move, hand_W));
  const std::uint64_t step = judged.move.update(hand_W, plenty).work; // that finds out that it rests
  ASSERT_GT(step, 8u);
  ASSERT_EQ(judged.move.update(hand_W, 1).steps, 1);
  std::uint64_t paid = 1;
  for (ToolUpdate next = judged.move.update(hand_W, 2); next.steps == 0; next = judged.move.update(hand_W, 2))
  {
    ASSERT_TRUE(next.spent);
    paid += next.work;
  }
  EXPECT_GE(paid + 2, step);
  EXPECT_LE(paid, step);
}

TEST(ToolWork, AToolOf5ThousandTrianglesOn100ThousandIsRarelyOutOfWork)
{
  EXPECT_LE(outOfWorkOf400(5000, 100000), 16);
}

TEST(ToolWork, AToolOf50ThousandTrianglesOnAMillionIsOutOfWorkInATenthOfItsUpdatesAtMost)
{
  EXPECT_LE(outOfWorkOf400(50000, 1000000), 40);
}

TEST(ToolWork, ATreeTellsANutOf240FacetsApartFromItsScrewByFewPairsOfBoxes)
{
  const TriangleMesh nut = nutOf240();
  const ToolMesh tool = makeTool(nut).value;
  const auto scene_W = makeToolScene(cleanMesh(screwOf240()).mesh, tool);
  PairFront front(*tool.shape_B, *scene_W, tool.restGap_u());
  WorkBudget budget(1u << 20);
  ASSERT_TRUE(front.gather({ tool.centre_W, Quat::Identity() }, 0.001, budget));
  // Two flanks of 45 degrees that are 0.3 apart along the radius. Boxes that hold both flanks of a thread overlap with
  // those of the other one, down to their leaves: cut at the median of the longest side, trees had 57,000 visits.
  EXPECT_LE((1u << 20) - budget.left(), 16000u);
}

TEST(ToolWork, ATreeOfTrianglesThatShrinkByHalfIsNotDeep)
{
  constexpr int triangles = 120;
  TriangleMesh mesh;
  for (int i = 0; i < triangles; ++i)
  {
    const double x = std::ldexp(1.0, -i);
    const auto first = static_cast<std::uint32_t>(mesh.vertices_W.size());
    for (const Vec3& p : { Vec3(1.0, 0.0, 0.0), Vec3(1.2, 0.0, 0.1), Vec3(1.0, 0.2, 0.0) })
    {
      mesh.vertices_W.push_back(x * p);
    }
    mesh.triangles.push_back({ first, first + 1, first + 2 });
  }
  const BoxedMesh tree(mesh, 0.0);
  const std::function<int(std::uint32_t)> depth = [&](std::uint32_t node)
  {
    const BoxedMesh::Node& of = tree.nodes()[node];
    return of.leaf() ? 1 : 1 + std::max(depth(node + 1), depth(of.second));
  };
  // The smallest boxes would come from cutting off the largest triangles, four at a time: 30 levels. Each part has an
  // eighth, and where no sixteenth of the extent gives that, a half.
  EXPECT_LE(depth(0), 3 * std::log2(triangles));
}

TEST(ToolWork, ANutOf240FacetsThatIsFreeOnItsScrewFollowsTheHandWithAThirdOfItsWork)
{
  constexpr double lead = pitchOf240 / (2.0 * std::numbers::pi);
  const TriangleMesh nut = nutOf240();
  const ToolMesh tool = makeTool(nut).value;
  const auto scene_W = makeToolScene(cleanMesh(screwOf240()).mesh, tool);
  ToolMove move(tool, scene_W, tool.gyration_u);
  ASSERT_EQ(move.place({ tool.centre_W, Quat::Identity() }), "");
  std::uint64_t work = 0;
  constexpr int updates = 40;
  for (int i = 1; i <= updates; ++i)
  {
    const double turn = 2.0 * std::numbers::pi * 1e-3 * i; // one turn a second
    const Pose hand_W{ tool.centre_W + Vec3(0, 0, lead * turn), Quat(Eigen::AngleAxisd(turn, Vec3::UnitZ())) };
    const ToolUpdate done = move.update(hand_W, ToolFollower::usualWork);
    EXPECT_FALSE(done.spent) << i;
    EXPECT_LE(turnFromTo(move.pose_W().q, hand_W.q).norm(), 1e-6) << i;
    work += done.work;
  }
  EXPECT_LE(work, updates * ToolFollower::usualWork / 3);
}

TEST(ToolWork, AGapThatIsKnownAfterAStepIsNeverLargerThanTheDistance)
{
  Random random(testSeed(3402));
  std::size_t kept = 0, asked = 0;
  for (const double turn_rad : { 0.0, 0.005, 0.05, 0.2 })
  {
    WatchedFront watched(scaled(NoisySphere(180, 1.0).mesh(), 0.4), NoisySphere(500, 1.0).mesh());
    watched.pose_W = { Vec3(73, 0, 0), Quat::Identity() };
    NearPairs pairs(*watched.tool.shape_B, *watched.scene_W);
    for (int i = 0; i < 60; ++i)
    {
      watched.gather(3.0);
      pairs.rebuild(watched.front.near(), watched.front.way_u(), watched.front.margin_u());
      const Vec3 home = (Vec3(73, 0, 0) - watched.pose_W.p) * 0.2;
      const Vec3 slid = random.uniform(0.0, 0.4) * Vec3(0, random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
      const ScrewStep step{ watched.pose_W, home + slid, turn_rad * random.direction() };
      WorkBudget plenty(1u << 24);
      const StepTask task{ step, step.displacement_u(watched.tool.reach_u), watched.front.way_u(), { 1e-4, 1e-3 } };
      const double share = random.uniform(0.2, 1.0) * proveStep(pairs, task, plenty).share;
      watched.front.moved(share * task.displacement_u, share * step.w_W.norm());
      pairs.made(share, watched.front.way_u());
      watched.pose_W = step.end_W(share);
      const double way_u = share * task.displacement_u;
      const auto judge = [&](const auto& pair, double distance_u)
      {
        EXPECT_LE(pairs.knownGap_u(pair), distance_u + 1e-12);
        if (pair.stepped.step > 0) // a plane was asked
        {
          kept += pairs.knownGap_u(pair) > pair.stepped.gap.from - 0.5 * way_u ? 1 : 0;
          ++asked;
        }
      };
      for (const NearTriangles& pair : pairs.triangles())
      {
        judge(pair, watched.distance_u(pair.toolTriangle, pair.sceneTriangle));
      }
      for (const LeafPair& pair : pairs.leaves())
      {
        judge(pair, watched.distance_u(pair));
      }
    }
  }
  EXPECT_GT(2 * kept, asked) << "of most pairs no more is known than the gap at the start, less the way";
}

} // namespace palpate::test
