// SPDX-License-Identifier: GPL-3.0-or-later
// Rigid bodies with mass: they fall, rest, slide, tip and sleep as mechanics says.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "LooseRig.h"
#include "haptics/tool/motion/Turn.h"

namespace palpate::test
{
namespace
{

constexpr int box = LooseRig::first;
constexpr double dt_s = 1e-3;
const Vec3 half_m(0.03, 0.02, 0.01);
const double mass_kg = stone_kg_per_m3 * 8.0 * half_m.prod();

Quat turned(double angle_rad, const Vec3& axis)
{
  return Quat(Eigen::AngleAxisd(angle_rad, axis.normalized()));
}

/// Kinetic energy between two poses, and potential energy in the second, of a box.
double energy_J(const Vec3& half, const Pose& from_W, const Pose& to_W)
{
  const double mass = stone_kg_per_m3 * 8.0 * half.prod();
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

TEST(BodyMass, OfAMeshIsThatOfTheBoxThatItIsWhereverItsFrameIs)
{
  const Vec3 half(0.3, 0.2, 0.1), aside(5.0, -3.0, 2.0);
  const double mass = 700.0 * 8.0 * half.prod();
  MechanismBody body;
  body.kind = MechanismBodyKind::Rigid;
  TriangleMesh mesh = boxOf(half);
  const Quat turn = turned(0.7, Vec3(1, 2, 3));
  std::ranges::for_each(mesh.vertices_W, [&](Vec3& p) { p = aside + turn * p; });
  body.mesh = heldMesh(mesh);
  body.pose_W = { Vec3(1, 0, 0), turned(0.4, Vec3(0, 1, 1)) };
  const Vec3 centre_W = body.pose_W * aside;
  const MassGiven given = giveMass(body, 700.0, 1.0);
  EXPECT_EQ(given.refusal, "");
  EXPECT_LE((given.centre_u - aside).norm(), 1e-12);
  EXPECT_LE((body.pose_W.p - centre_W).norm(), 1e-12);
  EXPECT_NEAR(body.mass.mass_Ns2_per_u, mass, 1e-10 * mass);
  const Vec3 square = half.cwiseAbs2();
  const Vec3 own = mass / 3.0 * Vec3(square.y() + square.z(), square.z() + square.x(), square.x() + square.y());
  const Mat3 r = turn.toRotationMatrix();
  EXPECT_LE((body.mass.inertia_N_s2_u - r * own.asDiagonal() * r.transpose()).norm(), 1e-10 * own.norm());
}

TEST(BodyMass, IsCountedInUnitsOfTheScene)
{
  MechanismBody metres, millimetres;
  metres.kind = millimetres.kind = MechanismBodyKind::Rigid;
  metres.halfSize_u = half_m;
  millimetres.halfSize_u = 1e3 * half_m;
  EXPECT_EQ(giveMass(metres, stone_kg_per_m3, 1.0).refusal + giveMass(millimetres, stone_kg_per_m3, 1e-3).refusal, "");
  // A newton gives a kilogram 1 m/s^2 = 1,000 mm/s^2, and 1 N m = 1,000 N mm the same spin.
  EXPECT_NEAR(millimetres.mass.mass_Ns2_per_u, 1e-3 * metres.mass.mass_Ns2_per_u, 1e-12);
  EXPECT_LE((millimetres.mass.inertia_N_s2_u - 1e3 * metres.mass.inertia_N_s2_u).norm(), 1e-12);
}

TEST(BodyMass, IsRefusedWithoutDensityOrVolume)
{
  for (const double density : { 0.0, -1.0, std::nan(""), 1e9 })
  {
    MechanismBody body;
    body.kind = MechanismBodyKind::Rigid;
    body.halfSize_u = half_m;
    EXPECT_NE(giveMass(body, density, 1.0).refusal.find("above 0"), std::string::npos) << density;
    EXPECT_FALSE(isLoose(body)) << density;
  }
  MechanismBody flat;
  flat.kind = MechanismBodyKind::Rigid;
  flat.halfSize_u = Vec3(1.0, 1.0, 0.0);
  EXPECT_NE(giveMass(flat, 1.0, 1.0).refusal.find("no volume"), std::string::npos);
}

TEST(Loose, RestsOnATableWithItsWeight)
{
  LooseRig rig(0.4);
  rig.add(half_m, Vec3(0.02, 0.03, half_m.z() + 2e-3), turned(0.3, Vec3::UnitZ()));
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
  const Quat askew = turned(0.4, Vec3::UnitZ());
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
      EXPECT_LE((contact.normal_W + Vec3::UnitZ()).norm(), 1e-12) << "the plate's lower face, in its frame";
      EXPECT_LE(
        (askew * contact.place_B.x_W - Vec3(contact.point_A.x(), contact.point_A.y(), -plate.z())).norm(), 1e-12);
      ++met;
    }
    EXPECT_FALSE(contact.mesh == box && contact.body == box + 1);
  }
  EXPECT_EQ(met, 4);
}

/// How far a box goes down a slope in a second.
double slid_m(double tilt_rad, double friction)
{
  const Quat slope = turned(tilt_rad, Vec3::UnitY());
  LooseRig rig(friction, slope);
  rig.add(half_m, Vec3(0, 0, half_m.z()));
  LooseRun run(rig.inputs);
  (void)run.rest(1.0);
  return (slope.conjugate() * run.pose_W(box).p).x();
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

TEST(Loose, BoxesThatMeetKeepTheMomentumThatAForceGives)
{
  LooseRig rig(0.4);
  constexpr double force_N = 0.5;
  rig.add(half_m, Vec3(0, 0, 0.3)).load_W = Vec3(force_N, 0, 0);
  rig.add(Vec3(0.02, 0.02, 0.02), Vec3(0.055, 0.004, 0.303), turned(0.2, Vec3::UnitY())).load_W.setZero();
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
    const Pose begin{ Vec3(0.02, 0.03, 0.08), turned(0.3 + 0.35 * shot, Vec3(1, 2 - shot, 3)) };
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

/// Three boxes on one another, each smaller than the one below.
struct Stack
{
  static constexpr double friction = 0.5;
  std::array<Vec3, 3> half_m{ Vec3(0.04, 0.03, 0.02), Vec3(0.03, 0.03, 0.015), Vec3(0.015, 0.03, 0.045) };

  [[nodiscard]] double weight_N(int from) const
  {
    double volume = 0.0;
    for (int k = from; k < 3; ++k)
    {
      volume += 8.0 * this->half_m[static_cast<std::size_t>(k)].prod();
    }
    return stone_kg_per_m3 * volume * gravity_m_per_s2;
  }
  [[nodiscard]] double below_m(int k) const
  {
    double z = 0.0;
    for (int i = 0; i < k; ++i)
    {
      z += 2.0 * this->half_m[static_cast<std::size_t>(i)].z();
    }
    return z;
  }
  /// The boxes from k on, as one, slide on the one below or tip about their front edge.
  struct Limit
  {
    double force_N = std::numeric_limits<double>::infinity();
    bool tips = false;
    int from = 0;
  };
  [[nodiscard]] Limit limitOf(int pushed) const
  {
    Limit least;
    const double height_m = this->below_m(pushed) + this->half_m[static_cast<std::size_t>(pushed)].z();
    for (int k = 0; k <= pushed; ++k)
    {
      const double tip_N =
        this->weight_N(k) * this->half_m[static_cast<std::size_t>(k)].x() / (height_m - this->below_m(k));
      const double slide_N = friction * this->weight_N(k);
      const Limit here{ std::min(tip_N, slide_N), tip_N < slide_N, k };
      least = here.force_N < least.force_N ? here : least;
    }
    return least;
  }
};

class PushedStack : public testing::TestWithParam<int>
{
};

TEST_P(PushedStack, TipsOrSlidesWhereStaticsSays)
{
  const Stack stack;
  const Stack::Limit limit = stack.limitOf(GetParam());
  for (const double share : { 0.99, 1.01 })
  {
    LooseRig rig(Stack::friction);
    for (int k = 0; k < 3; ++k)
    {
      const Vec3& half = stack.half_m[static_cast<std::size_t>(k)];
      MechanismBody& body = rig.add(half, Vec3(0, 0, stack.below_m(k) + half.z()));
      body.load_W.x() = k == GetParam() ? share * limit.force_N : 0.0;
    }
    LooseRun run(rig.inputs);
    (void)run.rest(0.6);
    double moved_m = 0.0, turned_rad = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      const Pose& now_W = run.pose_W(box + k);
      moved_m = std::max(moved_m, now_W.p.head<2>().norm());
      turned_rad = std::max(turned_rad, turnFromTo(Quat::Identity(), now_W.q).norm());
    }
    if (share < 1.0)
    {
      EXPECT_LE(moved_m, 1e-5);
      EXPECT_LE(turned_rad, 1e-4);
      continue;
    }
    const double pushed_m = run.pose_W(box + GetParam()).p.x();
    EXPECT_GT(pushed_m, 1e-3);
    EXPECT_EQ(turned_rad > 0.05, limit.tips) << turned_rad;
    if (!limit.tips && limit.from > 0)
    {
      EXPECT_LE(std::abs(run.pose_W(box + limit.from - 1).p.x()), 1e-5) << "what is below stays";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Each, PushedStack, testing::Values(0, 1, 2));

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

/// A box on the hand's spring and on one of its own, without weight.
class Coupled
{
public:
  Coupled(double hand_N_per_m, double own_N_per_m)
  {
    LooseRig rig(0.0);
    MechanismBody& body = rig.add(Vec3::Constant(0.02), Vec3(0, 0, 0.3));
    body.load_W.setZero();
    rig.inputs.mechanism.findsContacts = false;
    MechanismBody& hand = rig.inputs.mechanism.bodies.front();
    hand.mesh.reset();
    hand.length_u = 0.01;
    hand.diameter_u = 0.002;
    rig.inputs.mechanism.bodies[LooseRig::table].mesh.reset();
    MechanismConstraint grip, spring;
    grip.name = "grip";
    grip.kind = ConstraintKind::Attachment;
    grip.a = "hand";
    grip.b = "box 0";
    spring.name = "spring";
    spring.kind = ConstraintKind::Spring;
    spring.a = "box 0";
    spring.b = "table";
    spring.point_B = Vec3(0, 0, 0.3);
    spring.axis_B = Vec3::UnitX();
    spring.stiffness_N_per_u = own_N_per_m;
    rig.inputs.mechanism.laws = { grip, spring };
    MechanismHold hold = firmHold();
    hold.stiffness_N_per_m = hand_N_per_m;
    this->run_ = std::make_unique<LooseRun>(rig.inputs, dt_s, hold);
  }

  double next(double hand_m)
  {
    (void)this->run_->next(Vec3(hand_m, 0, 0.3));
    return this->run_->pose_W(box).p.x();
  }
  [[nodiscard]] double mass_kg() const { return this->run_->touch().plan().bodies[box].mass.mass_Ns2_per_u; }

private:
  std::unique_ptr<LooseRun> run_;
};

/// Whether the same box diverges where it is pushed by the forces of the tick before.
bool explodes(double mass_kg, double hand_N_per_m, double own_N_per_m)
{
  double x = 1e-3, v = 0.0;
  for (int i = 0; i < 20000 && std::abs(x) < 1.0; ++i)
  {
    v -= dt_s / mass_kg * (hand_N_per_m + own_N_per_m) * x;
    x += dt_s * v;
  }
  return std::abs(x) >= 1.0;
}

TEST(DirectCoupling, HoldsFarBeyondTheStiffnessAtWhichAnExplicitStepDoesNot)
{
  constexpr double own_N_per_m = 2e4;
  const double mass_kg = Coupled(1e3, own_N_per_m).mass_kg();
  const double limit_N_per_m = 4.0 * mass_kg / (dt_s * dt_s) - own_N_per_m;
  EXPECT_FALSE(explodes(mass_kg, 0.98 * limit_N_per_m, own_N_per_m));
  EXPECT_TRUE(explodes(mass_kg, 1.02 * limit_N_per_m, own_N_per_m));
  for (const double times : { 0.5, 1.02, 10.0, 100.0 })
  {
    const double hand_N_per_m = times * limit_N_per_m;
    Coupled coupled(hand_N_per_m, own_N_per_m);
    constexpr double hand_m = 1e-3;
    const double rests_m = hand_N_per_m * hand_m / (hand_N_per_m + own_N_per_m);
    for (int i = 0; i < 100; ++i)
    {
      EXPECT_LE(std::abs(coupled.next(hand_m) - rests_m), 1.001 * rests_m) << times << " at " << i;
    }
    for (int i = 0; i < 3000; ++i)
    {
      (void)coupled.next(hand_m);
    }
    EXPECT_NEAR(coupled.next(hand_m), rests_m, 1e-6 * rests_m) << times;
  }
}

/// The angle of a box that hangs from a point of the world, after a time.
double swung_rad(double tick_s, double until_s)
{
  constexpr double arm_m = 0.05;
  LooseRig rig(0.0);
  rig.add(Vec3::Constant(0.02), Vec3(arm_m, 0, 0.5));
  rig.inputs.mechanism.findsContacts = false;
  MechanismBody& hand = rig.inputs.mechanism.bodies.front();
  hand.mesh.reset();
  hand.length_u = 0.01;
  hand.diameter_u = 0.002;
  rig.inputs.mechanism.bodies[LooseRig::table].mesh.reset();
  MechanismBody& body = rig.inputs.mechanism.bodies.back();
  body.halfSize_u = Vec3::Constant(arm_m); // so that the pin lies in the box; the mass is that of the small one
  MechanismConstraint pin;
  pin.name = "pin";
  pin.kind = ConstraintKind::Attachment;
  pin.a = "box 0";
  pin.b = "table";
  pin.point_A = Vec3(-arm_m, 0, 0);
  pin.point_B = Vec3(0, 0, 0.5);
  rig.inputs.mechanism.laws = { pin };
  LooseRun run(rig.inputs, tick_s);
  (void)run.next(); // of a millisecond, as the first tick of a path is
  (void)run.rest(until_s - 1e-3);
  const Vec3 way = run.pose_W(box).p - pin.point_B;
  EXPECT_NEAR(way.norm(), arm_m, 1e-3 * arm_m);
  return std::atan2(-way.z(), way.x());
}

/// The same by small steps of a pendulum: I a'' = m g l cos a, from the horizontal.
double pendulum_rad(double until_s)
{
  const double half = 0.02, arm = 0.05;
  const double perMass = 2.0 / 3.0 * half * half + arm * arm;
  const auto spinUp = [&](double a) { return gravity_m_per_s2 * arm * std::cos(a) / perMass; };
  constexpr int steps = 200000;
  const double h = until_s / steps;
  double a = 0.0, w = 0.0;
  for (int i = 0; i < steps; ++i)
  {
    const double middle = w + 0.5 * h * spinUp(a);
    a += h * middle;
    w = middle + 0.5 * h * spinUp(a);
  }
  return a;
}

TEST(Loose, SwingsAsAPendulumDoesTheNearerTheShorterTheTick)
{
  constexpr double until_s = 0.16; // before the lowest place
  const double truth_rad = pendulum_rad(until_s);
  double before = 0.0;
  for (const double tick_s : { 1e-3, 5e-4, 2.5e-4 })
  {
    const double off_rad = std::abs(swung_rad(tick_s, until_s) - truth_rad);
    EXPECT_LE(off_rad, 10.0 * tick_s);
    EXPECT_GT(off_rad, 0.0);
    if (before > 0.0)
    {
      EXPECT_NEAR(before / off_rad, 2.0, 0.2) << tick_s;
    }
    before = off_rad;
  }
}

TEST(Loose, GoesTheSameWayToTheBitWhenItIsDoneAgain)
{
  std::array<Pose, 2> end;
  for (Pose& pose_W : end)
  {
    LooseRig rig(0.4);
    rig.add(half_m, Vec3(0.02, 0.03, 0.08), turned(0.7, Vec3(1, 2, 3)));
    rig.add(half_m, Vec3(0.03, 0.03, 0.14), turned(0.2, Vec3(3, 2, 1)));
    LooseRun run(rig.inputs);
    (void)run.rest(0.4);
    pose_W = run.pose_W(box + 1);
  }
  EXPECT_EQ(end[0].p, end[1].p);
  EXPECT_EQ(end[0].q.coeffs(), end[1].q.coeffs());
}

} // namespace
} // namespace palpate::test
