// SPDX-License-Identifier: GPL-3.0-or-later
// Random tools among posts, bars, torn sheets and shells, at hands that jump: where a tool is said to rest it could not
// come nearer, and its contacts give the force of its pose.
#include <gtest/gtest.h>

#include "Tools.h"
#include "haptics/tool/servo/ToolForce.h"
#include "testing/oracles/tool/RestJudge.h"
#include "testing/support/SoupMaker.h"

namespace palpate::test
{
namespace
{

constexpr double room_mm = 45.0;

/// Some triangles are divided by a point near to a side: each leaves a sliver.
TriangleMesh withSlivers(const TriangleMesh& mesh, double share, Random& random)
{
  TriangleMesh divided{ mesh.vertices_W, {} };
  for (const auto& [a, b, c] : mesh.triangles)
  {
    if (random.uniform() >= share)
    {
      divided.triangles.push_back({ a, b, c });
      continue;
    }
    const double off = random.uniform(1e-5, 1e-2), along = random.uniform(0.2, 0.8);
    const Vec3 side = (1.0 - along) * mesh.vertices_W[a] + along * mesh.vertices_W[b];
    const auto middle = static_cast<std::uint32_t>(divided.vertices_W.size());
    divided.vertices_W.push_back((1.0 - off) * side + off * mesh.vertices_W[c]);
    divided.triangles.push_back({ a, b, middle });
    divided.triangles.push_back({ b, c, middle });
    divided.triangles.push_back({ c, a, middle });
  }
  return divided;
}

TriangleMesh star(Random& random)
{
  TriangleMesh mesh = makeIcosphere(1, 8.0);
  for (Vec3& v : mesh.vertices_W)
  {
    v *= random.uniform() < 0.35 ? random.uniform(1.0, 1.5) : random.uniform(0.45, 0.7);
  }
  return mesh;
}

TriangleMesh randomShape(int kind, Random& random)
{
  switch (kind)
  {
    case 0:
      return makeBox(Vec3(-8, -5, -3), Vec3(8, 5, 3));
    case 1:
      return makeTorus(8.0, 2.5, 16, 8);
    case 2:
      return star(random);
    default:
      return withSlivers(makeBox(Vec3(-9, -6, -1), Vec3(9, 6, 1)), 0.8, random);
  }
}

TriangleMesh posts(Random& random)
{
  TriangleMesh mesh;
  for (int k = 0; k < 25; ++k)
  {
    const double x = 15.0 * (k / 5 - 2) + random.uniform(-3, 3), y = 15.0 * (k % 5 - 2) + random.uniform(-3, 3);
    const double height = random.uniform(15, 40), half = random.uniform(0.5, 2.5);
    const TriangleMesh post = makeBox(Vec3(x - half, y - half, -height), Vec3(x + half, y + half, height));
    append(mesh, rotated(post, turnBy(0.15 * random.uniform() * random.direction())));
  }
  return mesh;
}

TriangleMesh bars(Random& random)
{
  TriangleMesh mesh;
  for (int k = 0; k < 25; ++k)
  {
    const double a = 14.0 * (k / 5 - 2), b = 14.0 * (k % 5 - 2), half = random.uniform(0.4, 1.2);
    append(mesh, makeBox(Vec3(-40, a - half, b - half), Vec3(40, a + half, b + half)));
    append(mesh, makeBox(Vec3(a - half + 5, -40, b - half), Vec3(a + half + 5, 40, b + half)));
  }
  return mesh;
}

TriangleMesh tornSheet(Random& random)
{
  TriangleMesh sheet = makeSheet({ 90.0, 90.0, 10, 10, 0.35 }, random);
  for (Vec3& v : sheet.vertices_W)
  {
    v.z() = random.uniform(-2, 2);
  }
  sheet = withSlivers(sheet, 0.6, random);
  std::erase_if(sheet.triangles, [&](const auto&) { return random.uniform() < 0.12; });
  return sheet;
}

TriangleMesh shells(Random& random)
{
  TriangleMesh mesh;
  for (const double radius : { 18.0, 30.0, 45.0 })
  {
    TriangleMesh shell = makeIcosphere(2, radius);
    for (Vec3& v : shell.vertices_W)
    {
      v *= random.uniform(0.96, 1.0);
    }
    append(mesh, shell);
  }
  return mesh;
}

TriangleMesh obstaclesOf(int kind, Random& random)
{
  switch (kind)
  {
    case 0:
      return posts(random);
    case 1:
      return bars(random);
    case 2:
      return tornSheet(random);
    default:
      return shells(random);
  }
}

/// Somewhere in the workspace, or near the tool.
Pose jump(const Pose& tool_W, Random& random)
{
  const Pose far_W = randomPose(random, room_mm);
  const Vec3 way = random.inCube(12.0);
  const Quat turn = turnBy(0.5 * random.uniform() * random.direction());
  return random.uniform() < 0.5 ? far_W : Pose{ tool_W.p + way, turn * tool_W.q };
}

/// The pull of a tool's contacts, as shares of the spring from its pose to the hand.
struct PullOfContacts
{
  double unheld = 0.0; ///< of the motion to the hand: they give the force of the pose where it is 0
  double size = 0.0;
  double back = 0.0; ///< the part of it against the motion to the hand
};

PullOfContacts pullOf(const ToolMove& move, const Pose& hand_W)
{
  const ToolContacts set = move.contacts();
  bool cut = false;
  const Vec6 wish = wishedMotion(set.pose_W, hand_W, set.characteristic_u, cut);
  const Vec6 pull = toolPull(set, hand_W, ToolCoupling::Constraints).pull_u;
  return { (wish + pull).norm() / wish.norm(), pull.norm() / wish.norm(), -pull.dot(wish) / wish.squaredNorm() };
}

/// Counts of a tool at hands that jump and move on from there by little.
struct RestRun
{
  std::size_t states = 0, settled = 0, judged = 0, pressed = 0;

  void tally(const RestRun& other)
  {
    this->states += other.states;
    this->settled += other.settled;
    this->judged += other.judged;
    this->pressed += other.pressed;
  }
};

/// A random tool among random obstacles, whose updates are all judged.
class RestTrial
{
public:
  RestTrial(int kind, std::uint64_t seed)
    : seed_(seed), random_(seed), shape_(randomShape(kind / kindsEach, this->random_)),
      obstacles_(obstaclesOf(kind % kindsEach, this->random_)), tool_(this->shape_, this->obstacles_, 0),
      judge_(this->tool_.tool.shape_B->mesh(), this->tool_.scene_W->mesh(), this->tool_.tool.gyration_u)
  {
    this->tool_.move.watch(nullptr);
    while (!this->tool_.move.place(randomPose(this->random_, 38.0)).empty())
    {
    }
  }

  RestRun run(std::size_t jumps)
  {
    constexpr int moves = 4;
    for (std::size_t i = 0; i < jumps; ++i)
    {
      Pose hand_W = jump(this->tool_.move.pose_W(), this->random_);
      this->settle(hand_W);
      this->judgeGain(hand_W);
      for (int move = 0; move < moves; ++move)
      {
        hand_W.p += this->random_.inCube(0.5);
        hand_W.q = turnBy(0.02 * this->random_.uniform() * this->random_.direction()) * hand_W.q;
        this->settle(hand_W);
      }
    }
    return this->counts_;
  }

  static constexpr int kindsEach = 4, kinds = kindsEach * kindsEach;

private:
  /// Updates until it rests. An update that says so has contacts that give the force of its pose. After any other the
  /// tool still moves: the contacts allow it to stay, so the nearest motion that they allow lies within the ball over
  /// the spring, and the pull is no longer than the spring and not towards the hand.
  void settle(const Pose& hand_W)
  {
    constexpr int mostUpdates = 60; // of 60 steps of at most .2 rad: half a turn about each of many obstacles
    constexpr double rounding = 1e-9;
    ToolUpdate last;
    for (int u = 0; u < mostUpdates && !last.converged; ++u)
    {
      last = this->tool_.move.update(hand_W, plenty);
      ASSERT_FALSE(last.blocked) << this->seed_;
      this->touches_ = this->judge_.distance_u(this->tool_.move.pose_W(), hand_W) > 1e-3;
      if (this->touches_)
      {
        const PullOfContacts pull = pullOf(this->tool_.move, hand_W);
        EXPECT_LE(last.converged ? pull.unheld : 0.0, 1e-3) << this->seed_ << ", update " << u;
        EXPECT_LE(pull.size, 1.0 + rounding) << this->seed_ << ", update " << u;
        EXPECT_GE(pull.back, -rounding) << this->seed_ << ", update " << u;
      }
    }
    ++this->counts_.states;
    this->counts_.settled += last.converged ? 1 : 0;
    this->counts_.pressed += this->touches_ ? 1 : 0;
    this->leadCut_ = last.leadCut;
    EXPECT_FALSE(this->judge_.meets(this->tool_.move.pose_W())) << this->seed_;
  }

  /// Beyond the longest lead it is not the distance that falls.
  void judgeGain(const Pose& hand_W)
  {
    constexpr int trials = 150;
    constexpr double smallGain = 0.002; // of the tool's size
    if (this->touches_ && !this->leadCut_)
    {
      ++this->counts_.judged;
      EXPECT_LE(this->judge_.gain_u(this->tool_.move.pose_W(), hand_W, trials, this->random_),
        smallGain * this->tool_.tool.diagonal_u)
        << this->seed_;
    }
  }

  std::uint64_t seed_;
  Random random_;
  TriangleMesh shape_, obstacles_; ///< made in this order, so that a seed is one trial
  JudgedTool tool_;
  RestJudge judge_;
  RestRun counts_;
  bool touches_ = false, leadCut_ = false;
};

} // namespace

TEST(ToolRest, IsWhereTheToolCannotComeNearerAndItsContactsGiveTheForceOfItsPose)
{
  constexpr int jumps = 8;
  RestRun all;
  for (int kind = 0; kind < RestTrial::kinds; ++kind)
  {
    all.tally(RestTrial(kind, testSeed(5100 + static_cast<std::uint64_t>(kind))).run(testCount(jumps)));
  }
  EXPECT_EQ(all.settled, all.states);
  EXPECT_GT(all.pressed, all.states / 3);
  EXPECT_GT(all.judged, all.states / 20);
}

TEST(ToolRest, IsFoundWhereContactsTakeTurnsWherePairsStandAtTheProvenGapAndWhereEdgesAreNearlyParallel)
{
  struct Trial
  {
    int kind;
    std::uint64_t seed;
  };
  // A slivered box in shells, pushed in a circle of three poses by corners and edges that take turns; a star on bars
  // and a box on bars whose steps could not be proven.
  for (const Trial& trial : { Trial{ 15, 20015 }, Trial{ 9, 21009 }, Trial{ 1, 20001 } })
  {
    const RestRun run = RestTrial(trial.kind, trial.seed).run(8);
    EXPECT_EQ(run.settled, run.states) << trial.seed;
  }
}

TEST(ToolRest, OfABoxAboveAPlaneThatCouldStillComeDownIsSeenByItsJudge)
{
  Random random(testSeed(5101));
  const TriangleMesh box = makeBox(Vec3::Constant(-5), Vec3::Constant(5));
  const RestJudge judge(box, makeSheet({ 100.0, 100.0, 4, 4, 0.3 }, random), 4.0);
  const Pose hand_W{ Vec3(0, 0, 3), Quat::Identity() };
  for (const double height_mm : { 0.1, 0.5, 2.0 })
  {
    const double gain_mm = judge.gain_u({ Vec3(0, 0, 5.0 + height_mm), Quat::Identity() }, hand_W, 600, random);
    EXPECT_LE(gain_mm, height_mm);
    EXPECT_GE(gain_mm, 0.5 * height_mm);
  }
  EXPECT_TRUE(judge.meets({ Vec3(0, 0, 4.999), Quat::Identity() }));
  EXPECT_FALSE(judge.meets({ Vec3(0, 0, 5.001), Quat::Identity() }));
}

} // namespace palpate::test
