// SPDX-License-Identifier: GPL-3.0-or-later
// Shots of meshes in the hand at meshes that stand and at a soft plate, up to half a metre and ten radians a
// second: the mesh goes through nothing. Judge: exact predicates on the triangles at the poses of the ticks.
#include <algorithm>
#include <cmath>
#include <iterator>

#include <gtest/gtest.h>

#include "haptics/compliance/snapshot/PointCompliance.h"
#include "haptics/core/PoseMath.h"
#include "haptics/mechanism/BodyMass.h"
#include "testing/haptics/mechanism/HeldMesh.h"
#include "testing/haptics/tool/CrossingJudge.h"
#include "testing/support/Random.h"

namespace palpate::test
{
namespace
{

constexpr double mostSpeed_m_per_s = 0.5, mostSpin_rad_per_s = 10.0, tick_s = 1e-3;
constexpr std::array<double, 3> rates_Hz{ 100.0, 30.0, 15.0 };

/// Where a shot begins, where it leads into the target, and how it turns on its way.
struct ShotPlan
{
  Vec3 from, to, spin_rad_per_s;
  double speed_m_per_s = 0.0;
};

ShotPlan randomShot(Random& random, const Vec3& overTarget, double deep_m)
{
  ShotPlan shot;
  shot.from = overTarget + Vec3(random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05), random.uniform(0.03, 0.06));
  shot.to = overTarget + Vec3(random.uniform(-0.03, 0.03), random.uniform(-0.03, 0.03), -random.uniform(0.0, deep_m));
  shot.spin_rad_per_s = random.uniform(0.0, mostSpin_rad_per_s) * random.direction();
  shot.speed_m_per_s = random.uniform(0.05, mostSpeed_m_per_s);
  return shot;
}

/// A hand that goes from shot to shot: above the target from one beginning to the next, into it, and back.
class ShootingHand
{
public:
  explicit ShootingHand(const Vec3& from) { this->at_.p = from; }

  /// `tick`: called with the hand's pose in each.
  template<class Tick>
  void shoot(const ShotPlan& shot, const Tick& tick)
  {
    this->go(shot.from, mostSpeed_m_per_s, Vec3::Zero(), tick);
    this->go(shot.to, shot.speed_m_per_s, shot.spin_rad_per_s, tick);
    this->go(shot.from, mostSpeed_m_per_s, shot.spin_rad_per_s, tick);
  }

private:
  template<class Tick>
  void go(const Vec3& to, double speed_m_per_s, const Vec3& spin_rad_per_s, const Tick& tick)
  {
    const Vec3 from = this->at_.p;
    const int ticks = static_cast<int>(std::ceil((to - from).norm() / (speed_m_per_s * tick_s)));
    const double turn_rad = tick_s * spin_rad_per_s.norm();
    const Quat turn(Eigen::AngleAxisd(turn_rad, turn_rad > 0.0 ? spin_rad_per_s.normalized() : Vec3(Vec3::UnitX())));
    for (int i = 1; i <= ticks; ++i)
    {
      this->at_.p = from + (to - from) * i / ticks;
      this->at_.q = (turn * this->at_.q).normalized();
      tick(this->at_);
    }
  }

  Pose at_;
};

MechanismHold shotHold(double rate_Hz, double turning_N_m_per_rad)
{
  MechanismHold hold = firmHold(rate_Hz);
  hold.stiffness_N_per_m = 1000.0;
  hold.turning_N_m_per_rad = turning_N_m_per_rad;
  return hold;
}

/// A tool before a mesh that stands, far from the pad.
MechanismInputs beforeStanding(const TriangleMesh& tool, const TriangleMesh& target, double friction)
{
  MechanismInputs inputs = meshOnPad(tool, 3, friction);
  MechanismBody body;
  body.name = "target";
  body.mesh = heldMesh(target);
  inputs.mechanism.bodies.push_back(body);
  return inputs;
}

const Vec3 overTarget(0.5, 0.05, 0.0); ///< of each target that stands

/// Between two walls, little wider than the tools, above a floor.
TriangleMesh groove()
{
  TriangleMesh all;
  const auto add = [&all](const Vec3& low, const Vec3& high)
  {
    const auto first = static_cast<std::uint32_t>(all.vertices_W.size());
    const TriangleMesh box = makeBox(overTarget + low, overTarget + high);
    all.vertices_W.insert(all.vertices_W.end(), box.vertices_W.begin(), box.vertices_W.end());
    std::ranges::transform(box.triangles, std::back_inserter(all.triangles),
      [first](const std::array<std::uint32_t, 3>& t) {
        return std::array<std::uint32_t, 3>{ t[0] + first, t[1] + first, t[2] + first };
      });
  };
  add(Vec3(-0.06, -0.06, -0.03), Vec3(-0.009, 0.06, 0.0));
  add(Vec3(0.009, -0.06, -0.03), Vec3(0.06, 0.06, 0.0));
  add(Vec3(-0.06, -0.06, -0.05), Vec3(0.06, 0.06, -0.031));
  return all;
}

/// A round bone, a thin wall and a groove.
std::vector<TriangleMesh> standingTargets()
{
  return { shifted(makeIcosphere(3, 0.05), overTarget - Vec3(0, 0, 0.05)),
    makeBox(overTarget + Vec3(-0.06, -0.06, -0.003), overTarget + Vec3(0.06, 0.06, 0.0)), groove() };
}

/// A ball, a block and a thin plate.
std::vector<TriangleMesh> shotTools()
{
  return { makeIcosphere(2, 0.008), makeBox(Vec3(-0.008, -0.005, -0.003), Vec3(0.008, 0.005, 0.003)),
    makeBox(Vec3(-0.015, -0.015, -0.001), Vec3(0.015, 0.015, 0.001)) };
}

/// Held firmly, held so weakly that contacts turn the mesh over, and free to turn.
constexpr std::array<double, 3> turnings_N_m_per_rad{ 2.0, 0.01, 0.0 };

constexpr std::size_t shotsOfAHand = 10;

TEST(CrossingShots, AtMeshesThatStandMeetNoneOfTheirTriangles)
{
  Random random(testSeed(344));
  const std::vector<TriangleMesh> targets = standingTargets();
  const std::vector<TriangleMesh> tools = shotTools();
  const std::size_t count = testCount(90);
  std::size_t pressed = 0, crossings = 0;
  for (std::size_t hand = 0; hand * shotsOfAHand < count; ++hand)
  {
    const TriangleMesh& tool = tools[hand % tools.size()];
    const TriangleMesh& target = targets[hand / tools.size() % targets.size()];
    const ToolMesh whole = makeTool(tool).value;
    const CrossingJudge judge(*whole.shape_B, *makeToolScene(cleanMesh(target).mesh, whole), 0);
    const double turning_N_m_per_rad = turnings_N_m_per_rad[random.below(turnings_N_m_per_rad.size())];
    MeshTouch touch(beforeStanding(tool, target, random.uniform() < 0.5 ? 0.3 : 0.0),
      shotHold(rates_Hz[random.below(rates_Hz.size())], turning_N_m_per_rad));
    ShootingHand shooting(overTarget + Vec3(0, 0, 0.05));
    for (std::size_t s = 0; s < shotsOfAHand; ++s)
    {
      bool meets = false;
      shooting.shoot(randomShot(random, overTarget, 0.01),
        [&](const Pose& hand_W)
        {
          const MechanismResult& r = touch.to(hand_W);
          meets = meets || r.exact_W.force.norm() > 0.1;
          crossings += judge.crossings(r.pose_W[0].p, r.pose_W[0].q.toRotationMatrix());
        });
      pressed += meets ? 1 : 0;
    }
    ASSERT_EQ(crossings, 0U) << "hand " << hand;
  }
  EXPECT_GT(pressed, count / 3);
}

/// A tool above a thin wall on which a loose stone lies.
MechanismInputs beforeStoneOnWall(const TriangleMesh& tool, const TriangleMesh& wall, double friction)
{
  MechanismInputs inputs;
  MechanismBody held, standing, stone;
  held.name = "tool";
  held.kind = MechanismBodyKind::Held;
  held.mesh = heldMesh(tool);
  standing.name = "wall";
  standing.mesh = heldMesh(wall);
  stone.name = "stone";
  stone.kind = MechanismBodyKind::Rigid;
  stone.halfSize_u = Vec3(0.01, 0.008, 0.005);
  stone.pose_W.p = overTarget + stone.halfSize_u.z() * Vec3::UnitZ();
  EXPECT_EQ(giveMass(stone, 2500.0, 1.0).refusal, "");
  stone.load_W = -9.81 * stone.mass.mass_Ns2_per_u * Vec3::UnitZ();
  inputs.mechanism.bodies = { held, standing, stone };
  inputs.mechanism.findsContacts = true;
  inputs.mechanism.foundFriction = friction;
  return inputs;
}

/// The hand aims at the stone while it is over the wall: the tool may have the stone between the wall and itself.
TEST(CrossingShots, AtALooseStoneMeetNoTriangleOfTheWallThatItLiesOn)
{
  constexpr int stone = 2;
  const Vec3 half(0.06, 0.06, 0.003);
  const TriangleMesh wall = makeBox(overTarget - half, overTarget + Vec3(half.x(), half.y(), 0.0));
  Random random(testSeed(347));
  const std::vector<TriangleMesh> tools = shotTools();
  const std::size_t count = testCount(90);
  std::size_t pressed = 0, crossings = 0;
  for (std::size_t hand = 0; hand * shotsOfAHand < count; ++hand)
  {
    const TriangleMesh& tool = tools[hand % tools.size()];
    const ToolMesh whole = makeTool(tool).value;
    const CrossingJudge judge(*whole.shape_B, *makeToolScene(cleanMesh(wall).mesh, whole), 0);
    MeshTouch touch(beforeStoneOnWall(tool, wall, random.uniform() < 0.5 ? 0.3 : 0.0),
      shotHold(200.0, turnings_N_m_per_rad[random.below(turnings_N_m_per_rad.size())]));
    ShootingHand shooting(overTarget + Vec3(0, 0, 0.05));
    Vec3 stone_W = overTarget;
    for (std::size_t s = 0; s < shotsOfAHand; ++s)
    {
      const bool lies = ((stone_W - overTarget).array().abs() < half.array() + 0.02).all();
      const Vec3 over = lies ? Vec3(stone_W.x(), stone_W.y(), overTarget.z()) : overTarget;
      bool meets = false;
      shooting.shoot(randomShot(random, over, 0.01),
        [&](const Pose& hand_W)
        {
          const MechanismResult& r = touch.to(hand_W);
          stone_W = r.pose_W[stone].p;
          meets = meets || r.exact_W.force.norm() > 0.1;
          crossings += judge.crossings(r.pose_W[0].p, r.pose_W[0].q.toRotationMatrix());
        });
      pressed += meets ? 1 : 0;
    }
    ASSERT_EQ(crossings, 0U) << "hand " << hand;
  }
  EXPECT_GT(pressed, count / 3);
}

constexpr double plateHigh_m = 0.016;

/// A plate of two layers of cells that is held at its rim: as thick as two of its edges.
MechanismInputs beforePlate(const TriangleMesh& tool, double friction)
{
  const Vec3 size(0.1, 0.1, plateHigh_m);
  MechanismInputs inputs = meshOnPad(tool, 3, friction);
  SoftBodyInput plate = *inputs.soft.front().input;
  plate.mesh = blockOf({ 12, 12, 2 }, size);
  plate.fixed = fixedWhere(plate.mesh,
    [&size](const Vec3& p) { return p.x() == 0.0 || p.x() == size.x() || p.y() == 0.0 || p.y() == size.y(); });
  plate.young_Pa = { 2e5 };
  inputs.soft.front().input = std::make_shared<const SoftBodyInput>(plate);
  return inputs;
}

TEST(CrossingShots, AtASoftPlateDoNotPassIt)
{
  constexpr int every = 8; // ticks, in which a core of 4 mm does not jump over the plate
  const Vec3 above(0.05, 0.05, plateHigh_m);
  Random random(testSeed(345));
  const std::vector<TriangleMesh> tools{ makeIcosphere(2, 0.012),
    makeBox(Vec3::Constant(-0.008), Vec3::Constant(0.008)) };
  const std::size_t count = testCount(20);
  std::size_t pressed = 0, crossings = 0;
  for (std::size_t hand = 0; hand * shotsOfAHand < count; ++hand)
  {
    // One body may reach into the other by half an edge of the plate, 4 mm.
    const TriangleMesh& tool = tools[hand % tools.size()];
    const ToolMesh core = makeTool(scaled(tool, 0.3)).value;
    MeshTouch touch(
      beforePlate(tool, random.uniform() < 0.5 ? 0.3 : 0.0), shotHold(rates_Hz[random.below(rates_Hz.size())], 2.0));
    ShootingHand shooting(above + Vec3(0, 0, 0.05));
    int ticks = 0;
    for (std::size_t s = 0; s < shotsOfAHand; ++s)
    {
      bool meets = false;
      shooting.shoot(randomShot(random, above, 0.005),
        [&](const Pose& hand_W)
        {
          const MechanismResult& r = touch.to(hand_W);
          meets = meets || r.exact_W.force.norm() > 0.1;
          if (++ticks % every == 0)
          {
            const PressedBody& body = touch.body();
            TriangleMesh bent = body.scene->surfaces().front().tree->mesh();
            bent.vertices_W = bentBy(r, body);
            const CrossingJudge judge(*core.shape_B, *makeToolScene(bent, core), 0);
            crossings += judge.crossings(r.pose_W[0].p, r.pose_W[0].q.toRotationMatrix());
          }
        });
      pressed += meets ? 1 : 0;
    }
    ASSERT_EQ(crossings, 0U) << "hand " << hand;
  }
  EXPECT_GT(pressed, count / 3);
}

} // namespace
} // namespace palpate::test
