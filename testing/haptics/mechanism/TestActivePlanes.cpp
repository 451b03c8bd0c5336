// SPDX-License-Identifier: GPL-3.0-or-later
// Constraints whose line or plane is on the body in the hand, and turns with it, against the energy of the finite
// rotation.
#include <gtest/gtest.h>

#include "haptics/tool/motion/Turn.h"
#include "testing/oracles/statics/HeldRod.h"
#include "testing/support/MechanismRig.h"
#include "testing/support/Random.h"

namespace palpate::test
{
namespace
{

using Coordinates = FiniteStatics::Coordinates;

constexpr double bar = 0.15;
const Vec3 planePoint_B(0.01, -0.005, 0.1);
const Vec3 planeAxis_B = Vec3(0.4, -0.3, 1.0).normalized();

/// A constraint between a point of the world and a plane or a line of the bar, which meet where the hand is in the
/// origin.
class ActivePlanes : public testing::Test
{
protected:
  ActivePlanes() { this->rig.grip = { kc, kr }; }

  MechanismConstraint& join(ConstraintKind kind)
  {
    MechanismConstraint& law = this->rig.join(kind, "needle", planePoint_B, planePoint_B);
    law.a = "world";
    law.axis_A = law.axis_B = planeAxis_B;
    return law;
  }

  /// For hands at random, led there from where the constraint holds without force: where the bar comes to, and the
  /// wrench. `law` is added to the energy of the hand's springs, with `more` coordinates of its own.
  template<class Constraint>
  void judge(std::uint64_t seed, int more, const Constraint& law)
  {
    Random random(testSeed(seed));
    for (std::size_t trial = 0; trial < testCount(30); ++trial)
    {
      SCOPED_TRACE(trial);
      const Pose to{ random.inCube(4e-3), turnBy(random.inCube(0.25)) };
      this->rig.plan();
      const MechanismResult& r = this->lead(to);
      const HeldRod rod{ to.p, to.q, kc, kr };
      Eigen::VectorXd z = Eigen::VectorXd::Zero(6 + more);
      z.head<3>() = r.pose_W[0].p; // of several places of rest the one that is felt
      z.segment<3>(3) = rotationVector(r.pose_W[0].q * to.q.conjugate());
      const bool free = this->isFree(to);
      const auto energy = [&](const Coordinates& c) { return free ? rod.energy(c) : rod.energy(c) + law(rod, c); };
      z.conservativeResize(free ? 6 : 6 + more);
      ASSERT_TRUE(FiniteStatics::makeStationary(energy, z));
      EXPECT_LE((r.pose_W[0].p - z.head<3>()).norm(), 1e-12);
      EXPECT_LE((r.exact_W.force - rod.force(z)).norm(), 1e-9);
      EXPECT_LE((r.exact_W.torque - rod.moment(z)).norm(), 1e-10);
      this->pressed += r.exact_W.force.norm() > 0.0;
    }
    EXPECT_GT(this->pressed, 5);
  }

  const MechanismResult& lead(const Pose& to)
  {
    constexpr int parts = 40;
    const Vec3 turn = rotationVector(to.q);
    for (int i = 0; i < parts; ++i)
    {
      const double share = double(i) / parts;
      EXPECT_FALSE(this->rig.step(Pose{ share * to.p, turnBy(share * turn) }).capped) << i;
    }
    return this->rig.step(to);
  }

  /// A contact that the hand does not press.
  [[nodiscard]] bool isFree(const Pose& to) const
  {
    return this->rig.mechanism.laws[0].kind == ConstraintKind::Contact &&
           (to.q * planeAxis_B).dot(planePoint_B - (to.p + to.q * planePoint_B)) >= 0.0;
  }

  /// From the point of the bar to that of the world, along an axis of the bar.
  [[nodiscard]] static Jet before(const HeldRod& rod, const Coordinates& z, const Vec3& axis_B)
  {
    return dot(FiniteStatics::constant(planePoint_B, z) - rod.point(z, planePoint_B), rod.direction(z, axis_B));
  }

  int pressed = 0;
  MechanismRig rig{ bar };
};

TEST_F(ActivePlanes, ASpringAlongAnAxisOfTheBarTurnsWithIt)
{
  MechanismConstraint& law = this->join(ConstraintKind::Spring);
  law.stiffness_N_per_u = 700.0;
  law.rest_u = 1e-3;
  this->judge(2811, 0,
    [](const HeldRod& rod, const Coordinates& z)
    {
      const Jet beyond = before(rod, z, planeAxis_B) - 1e-3;
      return 0.5 * 700.0 * beyond * beyond;
    });
}

TEST_F(ActivePlanes, ALimitAlongAnAxisOfTheBarIsThatSpringBeyondItsStop)
{
  MechanismConstraint& law = this->join(ConstraintKind::Limit);
  law.stiffness_N_per_u = 700.0;
  law.least_u = 0.02; // more than the hand goes: it always pushes
  this->judge(2812, 0,
    [](const HeldRod& rod, const Coordinates& z)
    {
      const Jet beyond = before(rod, z, planeAxis_B) - 0.02;
      return 0.5 * 700.0 * beyond * beyond;
    });
}

TEST_F(ActivePlanes, AContactWithAPlaneOfTheBarPushesAcrossItAsItLeans)
{
  this->join(ConstraintKind::Contact);
  this->judge(2813, 1, [](const HeldRod& rod, const Coordinates& z) { return z[6] * before(rod, z, planeAxis_B); });
}

TEST_F(ActivePlanes, DryFrictionThatSticksHoldsThePlaceAlongTheBarsAxis)
{
  this->join(ConstraintKind::DryFriction).dryFriction_N = 1e3;
  this->judge(2814, 1, [](const HeldRod& rod, const Coordinates& z) { return z[6] * before(rod, z, planeAxis_B); });
}

TEST_F(ActivePlanes, ASliderKeepsThePointOfTheWorldOnTheLineOfTheBarAndBothAxesAlike)
{
  this->join(ConstraintKind::Slider);
  const Vec3 first = planeAxis_B.unitOrthogonal(), second = planeAxis_B.cross(first);
  this->judge(2815, 4,
    [&](const HeldRod& rod, const Coordinates& z)
    {
      const JetVector axis = rod.direction(z, planeAxis_B);
      return z[6] * before(rod, z, first) + z[7] * before(rod, z, second) +
             z[8] * dot(FiniteStatics::constant(first, z), axis) + z[9] * dot(FiniteStatics::constant(second, z), axis);
    });
}

} // namespace
} // namespace palpate::test
