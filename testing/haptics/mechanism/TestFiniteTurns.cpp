// SPDX-License-Identifier: GPL-3.0-or-later
// A rod that a hand's spring turns by some tenths of a radian, against the energy of the finite rotation.
#include <gtest/gtest.h>

#include "haptics/tool/motion/Turn.h"
#include "testing/oracles/statics/FiniteStatics.h"
#include "testing/support/MechanismRig.h"
#include "testing/support/Random.h"

namespace palpate::test
{
namespace
{

using Coordinates = FiniteStatics::Coordinates;

constexpr double turnedRod = 0.2;
const Vec3 turnedTip(0.0, 0.0, turnedRod);

JetVector rotated(const Quat& q, const Vec3& r, const Coordinates& z)
{
  return FiniteStatics::constant(q * r, z);
}

/// Of the hand's two springs: the first three coordinates are the rod's place, the next its turn from the hand's.
Jet energyOfHand(const Coordinates& z, const Pose& hand, const MechanismGrip& grip)
{
  const JetVector apart = FiniteStatics::vectorOf(z, 0) - hand.p;
  const JetVector turn = FiniteStatics::vectorOf(z, 3);
  return 0.5 * grip.coupling_N_per_u * dot(apart, apart) + 0.5 * grip.turning_Nu_per_rad * dot(turn, turn);
}

JetVector onRod(const Coordinates& z, const Pose& hand, const Vec3& r)
{
  return FiniteStatics::vectorOf(z, 0) + FiniteStatics::turned(FiniteStatics::vectorOf(z, 3), rotated(hand.q, r, z));
}

class FiniteTurns : public testing::Test
{
protected:
  FiniteTurns() { this->rig.grip = { kc, kr }; }

  /// To a pose in parts of the motion, as hands go, from the pose without forces.
  const MechanismResult& lead(const Pose& to, int parts = 40)
  {
    const Vec3 turn = rotationVector(to.q);
    for (int i = 0; i < parts; ++i)
    {
      const double share = double(i) / parts;
      const MechanismResult& r = this->rig.step(Pose{ share * to.p, turnBy(share * turn) });
      EXPECT_FALSE(r.capped) << i;
      EXPECT_LE(this->missed(r), r.residual_u + 1e-15) << i;
      EXPECT_LE(r.residual_u, 1e-13) << i;
    }
    return this->rig.step(to);
  }

  /// How far the tip is from where it is pinned.
  [[nodiscard]] double missed(const MechanismResult& r) const
  {
    return this->pinned ? (r.pose_W[0].p + r.pose_W[0].q * turnedTip - turnedTip).norm() : 0.0;
  }

  /// Coordinates near those that are judged: of several places of rest the one that is felt.
  [[nodiscard]] static Eigen::VectorXd begin(const MechanismResult& r, const Pose& hand, Eigen::Index coordinates)
  {
    Eigen::VectorXd z = Eigen::VectorXd::Zero(coordinates);
    z.head<3>() = r.pose_W[0].p;
    z.segment<3>(3) = rotationVector(r.pose_W[0].q * hand.q.conjugate());
    return z;
  }

  /// Of place, turn and wrench.
  void judge(const MechanismResult& r, const Pose& hand, const Eigen::VectorXd& z) const
  {
    EXPECT_LE((r.pose_W[0].p - z.head<3>()).norm(), 1e-12);
    EXPECT_LE((rotationVector(r.pose_W[0].q * hand.q.conjugate()) - z.segment<3>(3)).norm(), 1e-11);
    EXPECT_LE((r.exact_W.force - kc * (z.head<3>() - hand.p)).norm(), 1e-9);
    EXPECT_LE((r.exact_W.torque - kr * z.segment<3>(3)).norm(), 1e-10);
  }

  bool pinned = false;
  MechanismRig rig{ turnedRod };
};

Pose anyHand(Random& random, double way, double turn)
{
  return { random.inCube(way), turnBy(random.inCube(turn)) };
}

TEST_F(FiniteTurns, ATipOnItsPinStandsThereAndIsDrawnUpAsItsRodLeans)
{
  this->rig.join(ConstraintKind::Attachment, "world", turnedTip, turnedTip);
  this->pinned = true;
  // Turned by .01 the tip of a rod of 200 mm is .010 mm lower: so much is the hand's spring longer.
  const Pose hand{ Vec3::Zero(), turnBy(Vec3(0.01, 0.0, 0.0)) };
  MechanismRig stiff(turnedRod);
  stiff.grip = { kc, 1e9 };
  stiff.join(ConstraintKind::Attachment, "world", turnedTip, turnedTip);
  const MechanismResult& r = stiff.step(hand);
  EXPECT_NEAR(r.pose_W[0].p.z(), turnedRod * (1.0 - std::cos(0.01)), 1e-9);
  EXPECT_NEAR(r.pose_W[0].p.y(), turnedRod * std::sin(0.01), 1e-9);

  Random random(testSeed(2801));
  for (std::size_t trial = 0; trial < testCount(60); ++trial)
  {
    SCOPED_TRACE(trial);
    const Pose to = anyHand(random, 0.04, 0.6);
    this->rig.plan();
    const MechanismResult& rest = this->lead(to);
    EXPECT_LE(this->missed(rest), 1e-14);
    const auto energy = [&to](const Coordinates& z)
    {
      const JetVector gap = onRod(z, to, turnedTip) - turnedTip;
      return energyOfHand(z, to, { kc, kr }) + dot(FiniteStatics::vectorOf(z, 6), gap);
    };
    Eigen::VectorXd z = this->begin(rest, to, 9);
    z.segment<3>(6) = -rest.laws[0].force_W;
    ASSERT_TRUE(FiniteStatics::makeStationary(energy, z));
    this->judge(rest, to, z);
    EXPECT_NEAR(
      rest.stored_Nu, 0.5 * (kc * (z.head<3>() - to.p).squaredNorm() + kr * z.segment<3>(3).squaredNorm()), 1e-12);
  }
}

TEST_F(FiniteTurns, InOneTickFromFarTheTipIsOnItsPin)
{
  this->rig.join(ConstraintKind::Attachment, "world", turnedTip, turnedTip);
  const Pose to{ Vec3(0.05, -0.02, 0.01), turnBy(Vec3(0.5, 0.8, -0.3)) };
  const MechanismResult& r = this->rig.step(to);
  EXPECT_LE((r.pose_W[0].p + r.pose_W[0].q * turnedTip - turnedTip).norm(), 1e-14);
  EXPECT_FALSE(r.capped);
}

TEST_F(FiniteTurns, APushThatAlmostFoldsTheRodIsMetAndItsResidualIsTrueOnTheWay)
{
  this->rig.grip = { kc, 0.5 };
  this->rig.join(ConstraintKind::Attachment, "world", turnedTip, turnedTip);
  this->pinned = true;
  const Pose to{ Vec3(2e-4, 0.0, 0.012), Quat::Identity() }; // 12 N at .2 m: beyond the largest moment of the turning
                                                             // spring
  const MechanismResult& r = this->lead(to, 200);
  const auto energy = [&to](const Coordinates& z)
  {
    const JetVector gap = onRod(z, to, turnedTip) - turnedTip;
    return energyOfHand(z, to, { kc, 0.5 }) + dot(FiniteStatics::vectorOf(z, 6), gap);
  };
  Eigen::VectorXd z = this->begin(r, to, 9);
  z.tail<3>() = -r.laws[0].force_W;
  ASSERT_TRUE(FiniteStatics::makeStationary(energy, z));
  EXPECT_LE((r.pose_W[0].p - z.head<3>()).norm(), 1e-9);
  EXPECT_GT(r.exact_W.force.norm(), 2.5 * 0.5 / turnedRod) << "of the load that folds a rod in a fixed hand";
}

TEST_F(FiniteTurns, AHingeHoldsPointAndAxisOnTheTurnedRod)
{
  const Vec3 at(0.0, 0.01, 0.05), axis = Vec3(1.0, 0.2, -0.1).normalized();
  MechanismConstraint& law = this->rig.join(ConstraintKind::Hinge, "world", at, at);
  law.axis_A = law.axis_B = axis;
  Random random(testSeed(2802));
  for (std::size_t trial = 0; trial < testCount(30); ++trial)
  {
    SCOPED_TRACE(trial);
    const Pose to = anyHand(random, 0.03, 0.6);
    this->rig.plan();
    const MechanismResult& r = this->lead(to);
    const Vec3 first = axis.unitOrthogonal(), second = axis.cross(first);
    const auto energy = [&](const Coordinates& z)
    {
      const JetVector gap = onRod(z, to, at) - at;
      const JetVector turned = FiniteStatics::turned(FiniteStatics::vectorOf(z, 3), rotated(to.q, axis, z));
      return energyOfHand(z, to, { kc, kr }) + dot(FiniteStatics::vectorOf(z, 6), gap) +
             z[9] * dot(turned, FiniteStatics::constant(first, z)) +
             z[10] * dot(turned, FiniteStatics::constant(second, z));
    };
    Eigen::VectorXd z = this->begin(r, to, 11);
    z.segment<3>(6) = -r.laws[0].force_W;
    ASSERT_TRUE(FiniteStatics::makeStationary(energy, z));
    this->judge(r, to, z);
  }
}

/// A soft body that is one spring, and where its hole is.
struct Hole
{
  const char* name;
  double at_u;
  double stiffness_N_per_u;
};

TEST_F(FiniteTurns, AShaftInTwoHolesGivesWayAndLeansAsTheEnergyOfBothSpringsHasIt)
{
  const std::array holes{ Hole{ "wall", 0.05, 500.0 }, Hole{ "organ", 0.15, 200.0 } };
  for (const Hole& hole : holes)
  {
    const Vec3 at(0.0, 0.0, hole.at_u);
    this->rig.addSoft(hole.name, springWall(hole.name, at, -Vec3::UnitZ(), 0.02, 1.0 / hole.stiffness_N_per_u));
    this->rig.join(ConstraintKind::Insertion, hole.name, Vec3::Zero(), at);
  }
  Random random(testSeed(2803));
  for (std::size_t trial = 0; trial < testCount(30); ++trial)
  {
    SCOPED_TRACE(trial);
    const Pose to = anyHand(random, 0.02, 0.4);
    this->rig.plan();
    const MechanismResult& r = this->lead(to);
    // Coordinates: the rod's, of each hole its yield, the place on the shaft, and the force there.
    const auto energy = [&](const Coordinates& z)
    {
      Jet sum = energyOfHand(z, to, { kc, kr });
      for (std::size_t h = 0; h < holes.size(); ++h)
      {
        const std::size_t first = 6 + 7 * h;
        const JetVector yields = FiniteStatics::vectorOf(z, first);
        const JetVector axis = FiniteStatics::turned(FiniteStatics::vectorOf(z, 3), rotated(to.q, Vec3::UnitZ(), z));
        const JetVector gap =
          FiniteStatics::vectorOf(z, 0) + z[first + 3] * axis - yields - Vec3(0.0, 0.0, holes[h].at_u);
        sum = sum + 0.5 * holes[h].stiffness_N_per_u * dot(yields, yields) +
              dot(FiniteStatics::vectorOf(z, first + 4), gap);
      }
      return sum;
    };
    Eigen::VectorXd z = this->begin(r, to, 20);
    z[9] = holes[0].at_u;
    z[16] = holes[1].at_u;
    ASSERT_TRUE(FiniteStatics::makeStationary(energy, z));
    this->judge(r, to, z);
    EXPECT_LE((r.laws[0].force_W + z.segment<3>(10)).norm(), 1e-9);
    EXPECT_LE((r.laws[1].force_W + z.segment<3>(17)).norm(), 1e-9);
  }
}

TEST_F(FiniteTurns, AShaftThatSticksInItsHoleIsHeldAlongAsItLeans)
{
  const Vec3 at(0.0, 0.0, 0.1);
  this->rig.addSoft("wall", springWall("wall", at, -Vec3::UnitZ(), 0.02, 1.0 / tissue));
  this->rig.join(ConstraintKind::Insertion, "wall", Vec3::Zero(), at).dryFriction_N = 1e3;
  Random random(testSeed(2804));
  for (std::size_t trial = 0; trial < testCount(30); ++trial)
  {
    SCOPED_TRACE(trial);
    const Pose to = anyHand(random, 0.02, 0.5);
    this->rig.plan();
    const MechanismResult& r = this->lead(to);
    const auto energy = [&](const Coordinates& z)
    {
      const JetVector yields = onRod(z, to, at) - at; // the place on the shaft stays the same
      return energyOfHand(z, to, { kc, kr }) + 0.5 * tissue * dot(yields, yields);
    };
    Eigen::VectorXd z = this->begin(r, to, 6);
    ASSERT_TRUE(FiniteStatics::makeStationary(energy, z));
    this->judge(r, to, z);
  }
}

TEST_F(FiniteTurns, AContactOfTheTipIsPressedByThePlaneAloneHoweverTheRodLeans)
{
  MechanismConstraint& law = this->rig.join(ConstraintKind::Contact, "world", turnedTip, turnedTip);
  law.axis_B = Vec3(0.3, 0.1, -1.0).normalized();
  const Vec3 n = law.axis_B;
  Random random(testSeed(2805));
  int pressed = 0;
  for (std::size_t trial = 0; trial < testCount(40); ++trial)
  {
    SCOPED_TRACE(trial);
    const Pose to = anyHand(random, 0.006, 0.5);
    this->rig.plan();
    const MechanismResult& r = this->lead(to);
    if (r.exact_W.force.norm() == 0.0)
    {
      EXPECT_GE(n.dot(to.p + to.q * turnedTip - turnedTip), 0.0);
      continue;
    }
    ++pressed;
    const auto energy = [&](const Coordinates& z)
    {
      const JetVector gap = onRod(z, to, turnedTip) - turnedTip;
      return energyOfHand(z, to, { kc, kr }) + z[6] * dot(FiniteStatics::constant(n, z), gap);
    };
    Eigen::VectorXd z = this->begin(r, to, 7);
    z[6] = -r.exact_W.force.norm();
    ASSERT_TRUE(FiniteStatics::makeStationary(energy, z));
    EXPECT_LT(z[6], 0.0);
    this->judge(r, to, z);
  }
  EXPECT_GT(pressed, 5);
}

} // namespace
} // namespace palpate::test
