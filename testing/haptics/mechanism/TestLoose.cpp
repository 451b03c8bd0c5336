// SPDX-License-Identifier: GPL-3.0-or-later
// Rigid bodies with mass: they fall, rest, slide and sleep as mechanics says.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "LooseScenes.h"
#include "haptics/tool/motion/Turn.h"

namespace palpate::test
{
namespace
{

constexpr int box = LooseRig::first;
constexpr double dt_s = tickOfPath_s;
const Vec3 half_m = stoneHalf_m;
const double mass_kg = boxMass_kg(half_m);

/// Kinetic energy between two poses, and potential energy in the second, of a box.
double energy_J(const Vec3& half, const Pose& from_W, const Pose& to_W)
{
  const double mass = boxMass_kg(half);
  const Vec3 v = (to_W.p - from_W.p) / dt_s;
  const Vec3 w = from_W.q.conjugate() * Vec3(turnFromTo(from_W.q, to_W.q) / dt_s);
  const Vec3 square = half.cwiseAbs2();
  const Vec3 inertia = mass / 3.0 * Vec3(square.y() + square.z(), square.z() + square.x(), square.x() + square.y());
  return 0.5 * mass * v.squaredNorm() + 0.5 * w.dot(inertia.cwiseProduct(w)) + mass * gravity_m_per_s2 * to_W.p.z();
}

double lowest_m(const Vec3& half, const Pose& pose_W)
{
  double low = std::numeric_limits<double>::infinity();
  for (const Vec3& p : boxOf(half).vertices_W)
  {
    low = std::min(low, (pose_W * p).z());
  }
  return low;
}

TEST(Loose, RestsOnATableWithItsWeight)
{
  LooseRig rig(0.4);
  rig.add(half_m, Vec3(0.02, 0.03, half_m.z() + 2e-3), turnedBy(0.3, Vec3::UnitZ()));
  LooseRun run(rig.inputs);
  (void)run.rest(0.5);
  const double weight_N = mass_kg * gravity_m_per_s2;
  const Vec3 force_N = run.pressOn(box).first;
  EXPECT_NEAR(force_N.z(), weight_N, 1e-9 * weight_N);
  EXPECT_LE(force_N.head<2>().norm(), 1e-9 * weight_N);
  EXPECT_NEAR(run.pose_W(box).p.z(), half_m.z(), 2e-8);
  EXPECT_EQ(run.touch().bodies().found().count, 4) << "its corners, and no edge over a diagonal of the table's face";
  const Vec3 centre = run.pose_W(box).p;
  (void)run.rest(1.0);
  EXPECT_EQ(run.pose_W(box).p, centre) << "it sleeps";
}

TEST(Loose, APlaneTurnsWithTheBodyWhoseFaceItIs)
{
  const Vec3 plate(0.08, 0.08, 0.01), post(0.02, 0.02, 0.03);
  LooseRig rig(0.4);
  const Quat askew = turnedBy(0.4, Vec3::UnitZ());
  rig.add(plate, Vec3(0, 0, 2.0 * post.z() + plate.z()), askew);
  rig.add(post, Vec3(0, 0, post.z()));
  LooseRun run(rig.inputs);
  (void)run.next();
  const FoundContacts& found = run.touch().bodies().found();
  int met = 0;
  for (int i = 0; i < found.count; ++i)
  {
    const FoundContact& contact = found.contacts[static_cast<std::size_t>(i)];
    if (contact.mesh == box + 1 && contact.body == box)
    {
      EXPECT_LE((contact.point_A.cwiseAbs() - post).norm(), 1e-12) << "a corner of the post, in its frame";
      EXPECT_LE((contact.normal_B + Vec3::UnitZ()).norm(), 1e-12) << "the plate's lower face, in its frame";
      EXPECT_LE(
        (askew * contact.place_B.x_W - Vec3(contact.point_A.x(), contact.point_A.y(), -plate.z())).norm(), 1e-12);
      ++met;
    }
    EXPECT_FALSE(contact.mesh == box && contact.body == box + 1);
  }
  EXPECT_EQ(met, 4);
}

TEST(Loose, SlidesOnASlopeThatIsSteeperThanItsFrictionHolds)
{
  constexpr double tenth_rad = 0.1 * std::numbers::pi / 180.0;
  for (const double friction : { 0.2, 0.5 })
  {
    const double holds_rad = std::atan(friction), tilt_rad = holds_rad + tenth_rad;
    EXPECT_LE(std::abs(slid_m(holds_rad - tenth_rad, friction)), 1e-7) << friction;
    const double expected_m = 0.5 * gravity_m_per_s2 * (std::sin(tilt_rad) - friction * std::cos(tilt_rad));
    EXPECT_NEAR(slid_m(tilt_rad, friction), expected_m, 0.01 * expected_m) << friction;
  }
}

TEST(Loose, IsPushedOverAPlaneByForceLessFriction)
{
  constexpr double friction = 0.3, acceleration = 0.8;
  LooseRig rig(friction);
  MechanismBody& body = rig.add(half_m, Vec3(0, 0, half_m.z()));
  body.load_W.x() = mass_kg * (friction * gravity_m_per_s2 + acceleration);
  LooseRun run(rig.inputs);
  for (int i = 1; i <= 800; ++i)
  {
    const double before = i > 1 ? run.pose_W(box).p.x() : 0.0;
    (void)run.next();
    EXPECT_NEAR((run.pose_W(box).p.x() - before) / dt_s, acceleration * dt_s * i, 0.01 * acceleration * dt_s * i) << i;
  }
}

/// A hand that accelerates a box, and stops: the box coasts.
class Coasting : public testing::Test
{
protected:
  static constexpr double friction = 0.3;
  static constexpr int pushes = 200, coasts = 400;

  static Vec3 handAt(int tick)
  {
    const double t = dt_s * std::min(tick, pushes);
    const double gone = tick > pushes ? -0.05 : 0.0; // the hand goes back
    return { -half_m.x() - LooseRig::pusher_m - 1e-4 + 0.5 * 2.0 * t * t + gone, 0.0, half_m.z() };
  }
};

TEST_F(Coasting, GoesByTheHandsForceLessFrictionThenSlowsStopsAndSleeps)
{
  LooseRig rig(friction);
  rig.add(half_m, Vec3(0, 0, half_m.z()));
  LooseRun run(rig.inputs);
  double impulse = 0.0, v = 0.0, energy = 0.0, at_m = 0.0;
  for (int i = 0; i < pushes + coasts; ++i)
  {
    const Pose before = i > 0 ? run.pose_W(box) : Pose{ Vec3(0, 0, half_m.z()), Quat::Identity() };
    const MechanismResult& r = run.next(handAt(i));
    v = (run.pose_W(box).p.x() - before.p.x()) / dt_s;
    // The contacts are springs, too: where friction ends, the box goes back by nanometres.
    const double now_J = energy_J(half_m, before, run.pose_W(box)) + r.stored_Nu;
    if (i <= pushes)
    {
      const bool slides = v > 1e-6; // else its friction holds it
      impulse += slides ? dt_s * (-r.exact_W.force.x() - friction * mass_kg * gravity_m_per_s2) : 0.0;
      EXPECT_NEAR(mass_kg * v, impulse, 0.01 * mass_kg * 0.4) << i;
      at_m = run.pose_W(box).p.x();
      energy = now_J;
      continue;
    }
    EXPECT_LE(now_J, energy * (1.0 + 1e-12)) << i;
    energy = now_J;
  }
  const double began = impulse / mass_kg;
  EXPECT_GT(began, 0.3);
  EXPECT_NEAR(run.pose_W(box).p.x() - at_m, began * began / (2.0 * friction * gravity_m_per_s2), 0.01 * at_m);
  const Pose stopped = run.pose_W(box);
  (void)run.rest(0.5);
  EXPECT_EQ(run.pose_W(box).p, stopped.p);
  EXPECT_EQ(run.pose_W(box).q.coeffs(), stopped.q.coeffs());
}

TEST_F(Coasting, PushesTheHandAsTheHandPushes)
{
  LooseRig rig(friction);
  rig.add(half_m, Vec3(0, 0, half_m.z()));
  LooseRun run(rig.inputs);
  int pressed = 0;
  for (int i = 0; i < pushes; ++i)
  {
    const MechanismResult& r = run.next(handAt(i));
    const Vec3 spring_N = firmHold().stiffness_N_per_m * (run.pose_W(LooseRig::held).p - handAt(i));
    const Vec3 onBox_N = run.pressOn(box, LooseRig::held).first;
    EXPECT_LE((r.exact_W.force + onBox_N).norm(), 1e-12 * std::max(1.0, onBox_N.norm())) << i;
    if (!r.ahead)
    {
      EXPECT_LE((spring_N + onBox_N).norm(), 1e-10) << i << ": a hundredth of a picometre of the spring";
    }
    pressed += onBox_N.norm() > 0.0 ? 1 : 0;
  }
  EXPECT_GT(pressed, pushes / 2);
}

/// Nothing resists the turn of such a ball about the normal of its contact.
TEST(Loose, SlidesBeforeABallThatTurnsFreelyWithEachTickMet)
{
  constexpr double friction = 0.3;
  const Vec3 half(0.016, 0.014, 0.009);
  LooseRig rig(friction);
  rig.inputs.mechanism.bodies.front().mesh = heldMesh(makeIcosphere(2, 0.006));
  rig.add(half, Vec3(0, 0, half.z()));
  MechanismHold hold = firmHold();
  hold.stiffness_N_per_m = 1000.0;
  hold.turning_N_m_per_rad = 0.0;
  LooseRun run(rig.inputs, dt_s, hold);
  double push_N = 0.0;
  for (int i = 0; i < 1000; ++i)
  {
    const MechanismResult& r = run.next(Vec3(-0.03 + 2e-5 * i, 0, 0.01));
    EXPECT_FALSE(r.capped) << i;
    push_N = -r.exact_W.force.x();
  }
  const double slides_N = friction * boxMass_kg(half) * gravity_m_per_s2;
  EXPECT_NEAR(push_N, slides_N, 0.01 * slides_N);
}

TEST(Loose, BoxesThatMeetKeepTheMomentumThatAForceGives)
{
  LooseRig rig(0.4);
  constexpr double force_N = 0.5;
  rig.add(half_m, Vec3(0, 0, 0.3)).load_W = Vec3(force_N, 0, 0);
  rig.add(Vec3(0.02, 0.02, 0.02), Vec3(0.055, 0.004, 0.303), turnedBy(0.2, Vec3::UnitY())).load_W.setZero();
  const double other_kg = stone_kg_per_m3 * 8.0 * 0.02 * 0.02 * 0.02;
  LooseRun run(rig.inputs);
  bool met = false;
  for (int i = 1; i <= 400; ++i)
  {
    const std::array before = i > 1 ? std::array{ run.pose_W(box).p, run.pose_W(box + 1).p }
                                    : std::array{ Vec3(0, 0, 0.3), Vec3(0.055, 0.004, 0.303) };
    (void)run.next();
    const Vec3 momentum =
      (mass_kg * (run.pose_W(box).p - before[0]) + other_kg * (run.pose_W(box + 1).p - before[1])) / dt_s;
    EXPECT_LE((momentum - Vec3(force_N * dt_s * i, 0, 0)).norm(), 1e-12) << i;
    met = met || run.pressOn(box, box + 1).first.norm() > 0.0;
  }
  EXPECT_TRUE(met);
}

TEST(Loose, TumblesOntoATableWithoutGainingEnergyAndComesToRest)
{
  for (int shot = 0; shot < 8; ++shot)
  {
    LooseRig rig(0.4);
    const Pose begin{ Vec3(0.02, 0.03, 0.08), turnedBy(0.3 + 0.35 * shot, Vec3(1, 2 - shot, 3)) };
    rig.add(half_m, begin.p, begin.q);
    LooseRun run(rig.inputs);
    double energy = std::numeric_limits<double>::infinity(), lowest = 0.0;
    for (int i = 0; i < 2000; ++i)
    {
      const Pose before = i > 0 ? run.pose_W(box) : begin;
      (void)run.next();
      const double now_J = energy_J(half_m, before, run.pose_W(box));
      EXPECT_LE(now_J, energy + 1e-5 * mass_kg * gravity_m_per_s2 * begin.p.z()) << shot << " at " << i;
      energy = now_J;
      lowest = std::min(lowest, lowest_m(half_m, run.pose_W(box)));
    }
    EXPECT_GE(lowest, -2e-4) << shot;
    const Pose rests = run.pose_W(box);
    (void)run.rest(0.3);
    EXPECT_EQ(run.pose_W(box).p, rests.p) << shot;
    EXPECT_NEAR(lowest_m(half_m, rests), 0.0, 1e-6) << shot;
  }
}

TEST(Loose, FallsForEverAndSleepsAtTenTimesTheScene)
{
  LooseRig rig(0.4);
  rig.add(half_m, Vec3(1.2, 0, 0.1));
  LooseRun run(rig.inputs);
  const double scene_m = std::sqrt(2.0 * 2.0 + 2.0 * 2.0);
  int ticks = 0;
  for (Pose before{ Vec3(0, 0, 1), {} }; ticks < 10000 && run.next().pose_W[box].p != before.p; ++ticks)
  {
    before = run.pose_W(box);
  }
  EXPECT_LT(ticks, 10000);
  EXPECT_GT(-run.pose_W(box).p.z(), 10.0 * scene_m);
  EXPECT_LT(-run.pose_W(box).p.z(), 20.0 * scene_m);
  EXPECT_TRUE(run.pose_W(box).p.allFinite());
}

TEST(Loose, GoesTheSameWayToTheBitWhenItIsDoneAgain)
{
  std::array<Pose, 2> end;
  for (Pose& pose_W : end)
  {
    LooseRig rig(0.4);
    rig.add(half_m, Vec3(0.02, 0.03, 0.08), turnedBy(0.7, Vec3(1, 2, 3)));
    rig.add(half_m, Vec3(0.03, 0.03, 0.14), turnedBy(0.2, Vec3(3, 2, 1)));
    LooseRun run(rig.inputs);
    (void)run.rest(0.4);
    pose_W = run.pose_W(box + 1);
  }
  EXPECT_EQ(end[0].p, end[1].p);
  EXPECT_EQ(end[0].q.coeffs(), end[1].q.coeffs());
}

} // namespace
} // namespace palpate::test
