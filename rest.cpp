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
inline int tkind,tseed;
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

/// Somewhere in the room, or near the tool.
Pose jump(const Pose& tool_W, Random& random)
{
  const Pose far_W = randomPose(random, room_mm);
  const Vec3 way = random.inCube(12.0);
  const Quat turn = turnBy(0.5 * random.uniform() * random.direction());
  return random.uniform() < 0.5 ? far_W : Pose{ tool_W.p + way, turn * tool_W.q };
}

/// How much of the motion to the hand the contacts leave open: they give the force of the pose where it is nothing.
double unheld(const ToolMove& move, const Pose& hand_W)
{
  const ToolContacts set = move.contacts();
  bool cut = false;
  const Vec6 wish = wishedMotion(set.pose_W, hand_W, set.lever_u, cut);
  return (wish + toolPull(set, hand_W, ToolCoupling::Constraints).pull_u).norm() / wish.norm();
}

/// What became of a tool at hands that jump and move on from there by little.
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
  /// Updates until it rests; after each that says so its contacts are to give the force of its pose.
  void settle(const Pose& hand_W)
  {
    constexpr int mostUpdates = 12;
    ToolUpdate last;
    for (int u = 0; u < mostUpdates && !last.converged; ++u)
    {
      last = this->tool_.move.update(hand_W, plenty);
      ASSERT_FALSE(last.blocked) << this->seed_;
      this->touches_ = this->judge_.distance_u(this->tool_.move.pose_W(), hand_W) > 1e-3;
      if (last.converged && this->touches_)
      {
        EXPECT_LE(unheld(this->tool_.move, hand_W), 1e-3) << this->seed_ << ", update " << u;
      }
    }
    if(!last.converged) this->trace(hand_W);
    if(getenv("AFTER")) std::printf("kind %d seed %d state %zu conv %d u %d unheld %g\n",tkind,tseed,this->counts_.states,last.converged,0,unheld(this->tool_.move,hand_W));
    ++this->counts_.states;
    this->counts_.settled += last.converged ? 1 : 0;
    this->counts_.pressed += this->touches_ ? 1 : 0;
    this->leadCut_ = last.leadCut;
    EXPECT_FALSE(this->judge_.meets(this->tool_.move.pose_W())) << this->seed_;
  }

  void trace(const Pose& hand_W)
  {
    std::printf("UNSETTLED kind %d seed %d state %zu restgap %g lever %g\n",tkind,tseed,this->counts_.states,this->tool_.tool.restGap_u(),this->tool_.tool.gyration_u);
    struct Sink:StepSink{ std::vector<std::pair<ScrewStep,double>> s; void step(const ScrewStep&st,double sh) override{s.push_back({st,sh});} } sink;
    ToolMove copy=this->tool_.move; copy.watch(&sink);
    int upds=getenv("UPD")?atoi(getenv("UPD")):30;
    for(int u=0;u<upds;++u){ const Pose b=copy.pose_W(); sink.s.clear();
      auto d=copy.update(hand_W,plenty);
      std::printf(" u%d conv %d spent %d blocked %d steps %d work %lu cut %d moved %.3g dist %.12g unheld %.3g rows %zu\n",u,d.converged,d.spent,d.blocked,d.steps,(unsigned long)d.work,d.leadCut,this->judge_.distance_u(b,copy.pose_W()),this->judge_.distance_u(copy.pose_W(),hand_W),unheld(copy,hand_W),copy.rows().size());
      if(u<2&&getenv("STEPS")) for(auto&[st,sh]:sink.s) std::printf("    v %.3g w %.3g share %.3g pitchdot\n",st.v_W.norm(),st.w_W.norm(),sh);
      if(u<2||u>upds-3){ for(auto&r:copy.rows()){auto p=planeAt(r.feature,copy.pose_W().q.toRotationMatrix(),copy.pose_W().p); std::printf("    kind %d gap/rest %.4f n %.5f %.5f %.5f arm %.4f %.4f %.4f\n",int(r.feature.kind),p.gap_u/this->tool_.tool.restGap_u(),p.n_W.x(),p.n_W.y(),p.n_W.z(),p.arm_W.x(),p.arm_W.y(),p.arm_W.z());} }
    }
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


} // namespace
int main(int argc,char**argv){ using namespace palpate::test; ::testing::InitGoogleTest(&argc,argv); int from=atoi(argv[1]), to=atoi(argv[2]); int jumps=argc>3?atoi(argv[3]):8;
 RestRun all; for(int s=from;s<to;++s) for(int kind=0;kind<RestTrial::kinds;++kind){ tkind=kind; tseed=s; all.tally(RestTrial(kind,std::uint64_t(s)*1000+kind).run(jumps)); }
 printf("states %zu settled %zu judged %zu pressed %zu\n",all.states,all.settled,all.judged,all.pressed); }
