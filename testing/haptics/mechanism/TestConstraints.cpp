// SPDX-License-Identifier: GPL-3.0-or-later
// Each constraint of docs/theory.md, "Constraints between bodies", against its closed form: a rod of .2 m in a hand of
// 1000 N/m and 2 N m/rad.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "haptics/tool/motion/Turn.h"
#include "testing/oracles/statics/HeldRod.h"
#include "testing/support/MechanismRig.h"

namespace palpate::test
{
namespace
{

constexpr double length = 0.2;
const Vec3 tip(0.0, 0.0, length);

class Constraints : public testing::Test
{
protected:
  Constraints() { this->rig.grip = { kc, kr }; }

  MechanismRig rig{ length };
};

TEST_F(Constraints, AContactPushesByTheSpringsInSeriesAndNeverPulls)
{
  this->rig.addSoft("wall", springWall("wall", tip, -Vec3::UnitZ(), 0.02, 1.0 / tissue));
  this->rig.join(ConstraintKind::Contact, "wall", tip, tip).axis_B = -Vec3::UnitZ();
  const double depth = 3e-3;
  const MechanismResult& in = this->rig.step(Vec3(0.0, 0.0, depth));
  EXPECT_NEAR(in.wrench_W.force.z(), -depth / (1.0 / kc + 1.0 / tissue), 1e-12);
  EXPECT_LE(in.residual_u, 1e-15);
  const MechanismResult& out = this->rig.step(Vec3(0.0, 0.0, -depth));
  EXPECT_EQ(out.wrench_W.force.norm(), 0.0);
  EXPECT_EQ(out.laws[0].phase, ConstraintPhase::Open);
  EXPECT_EQ(out.residual_u, 0.0);
}

/// Where the rod of that hand rests with a constraint of so many coordinates of its own added to the energy of the
/// springs.
template<class Constraint>
Eigen::VectorXd restOf(const HeldRod& rod, int more, const Constraint& law)
{
  Eigen::VectorXd z = Eigen::VectorXd::Zero(6 + more);
  EXPECT_TRUE(
    FiniteStatics::makeStationary([&](const FiniteStatics::Coordinates& c) { return rod.energy(c) + law(c); }, z));
  return z;
}

TEST_F(Constraints, AnAttachmentHoldsThePointAsTheRodLeans)
{
  this->rig.join(ConstraintKind::Attachment, "world", tip, tip);
  const Pose hand{ Vec3(2e-3, 0.0, 1e-3), turnBy(Vec3(0.05, -0.02, 0.1)) };
  const MechanismResult& r = this->rig.step(hand);
  const HeldRod rod{ hand.p, hand.q, kc, kr };
  const auto pin = [&](const FiniteStatics::Coordinates& z)
  { return kc * dot(FiniteStatics::vectorOf(z, 6), rod.point(z, tip) - tip); };
  const Eigen::VectorXd z = restOf(rod, 3, pin);
  EXPECT_LE((r.wrench_W.force - rod.force(z)).norm(), 1e-11);
  EXPECT_LE((r.wrench_W.torque - rod.moment(z)).norm(), 1e-12);
  EXPECT_LE((r.pose_W[0].p + r.pose_W[0].q * tip - tip).norm(), 1e-15);
  EXPECT_LE(r.residual_u, 1e-15);
}

TEST_F(Constraints, AHingeHoldsPointAndAxisAndLeavesTheTurnAboutIt)
{
  MechanismConstraint& law = this->rig.join(ConstraintKind::Hinge, "world", Vec3::Zero(), Vec3::Zero());
  law.axis_A = law.axis_B = Vec3::UnitX();
  const Pose hand{ Vec3::Zero(), turnBy(Vec3(0.1, 0.2, -0.3)) };
  const MechanismResult& r = this->rig.step(hand);
  const HeldRod rod{ hand.p, hand.q, kc, kr };
  const auto pin = [&](const FiniteStatics::Coordinates& z)
  {
    const JetVector axis = rod.direction(z, Vec3::UnitX());
    return kc * dot(FiniteStatics::vectorOf(z, 6), rod.point(z, Vec3::Zero())) + kr * (z[9] * axis.y + z[10] * axis.z);
  };
  const Eigen::VectorXd z = restOf(rod, 5, pin);
  EXPECT_LE((r.wrench_W.torque - rod.moment(z)).norm(), 1e-12);
  EXPECT_NEAR(r.wrench_W.torque.x(), 0.0, 1e-12) << "about the axis nothing holds it";
  EXPECT_NEAR(rotationVector(r.pose_W[0].q).tail<2>().norm(), 0.0, 1e-14);
  EXPECT_LE(r.residual_u, 1e-15);
}

TEST_F(Constraints, ASliderLeavesTheWayAlongItsAxisAndTheTurnAboutIt)
{
  MechanismConstraint& law = this->rig.join(ConstraintKind::Slider, "world", Vec3::Zero(), Vec3::Zero());
  law.axis_A = law.axis_B = Vec3::UnitZ();
  const Pose hand{ Vec3(1e-3, -2e-3, 7e-3), turnBy(Vec3(0.1, -0.05, 0.3)) };
  const MechanismResult& r = this->rig.step(hand);
  const HeldRod rod{ hand.p, hand.q, kc, kr };
  const auto rail = [&](const FiniteStatics::Coordinates& z)
  {
    const JetVector axis = rod.direction(z, Vec3::UnitZ());
    return kr * (z[6] * axis.x + z[7] * axis.y) + kc * (z[8] * z[0] + z[9] * z[1]);
  };
  const Eigen::VectorXd z = restOf(rod, 4, rail);
  EXPECT_LE((r.wrench_W.force - Vec3(-kc * hand.p.x(), -kc * hand.p.y(), 0.0)).norm(), 1e-12);
  EXPECT_LE((r.wrench_W.torque - rod.moment(z)).norm(), 1e-12);
  EXPECT_NEAR(r.wrench_W.torque.z(), 0.0, 1e-12);
  EXPECT_NEAR(r.pose_W[0].p.z(), hand.p.z(), 1e-15);
  EXPECT_LE(r.residual_u, 1e-15);
}

TEST_F(Constraints, ABreakHoldsUpToItsStrengthAndIsGoneBeyond)
{
  this->rig.join(ConstraintKind::Break, "world", Vec3::Zero(), Vec3::Zero()).strength_N = 2.0;
  const MechanismResult holds = this->rig.step(Vec3(1.999e-3, 0.0, 0.0));
  EXPECT_NEAR(holds.wrench_W.force.x(), -1.999, 1e-12);
  EXPECT_EQ(holds.eventCount, 0);
  const MechanismResult breaks = this->rig.step(Vec3(2.001e-3, 0.0, 0.0));
  ASSERT_EQ(breaks.eventCount, 1);
  EXPECT_EQ(breaks.events[0].change, ConstraintChange::Broken);
  EXPECT_EQ(breaks.events[0].tick, 2u);
  EXPECT_NEAR(breaks.events[0].force_N, 2.001, 1e-12);
  EXPECT_EQ(breaks.exact_W.force.norm(), 0.0);
  const MechanismResult after = this->rig.step(Vec3::Zero());
  EXPECT_EQ(after.laws[0].phase, ConstraintPhase::Gone);
  EXPECT_EQ(after.exact_W.force.norm(), 0.0);
}

TEST_F(Constraints, ABreakThatTheHandBeginsFarFromWaitsUntilItHoldsAndIsThenFeltWithoutAStep)
{
  this->rig.join(ConstraintKind::Break, "world", Vec3::Zero(), Vec3::Zero()).strength_N = 2.0;
  double before_N = 0.0, largestStep_N = 0.0;
  for (int i = 0; i <= 200; ++i)
  {
    const double x = 0.02 - 1e-4 * i; // from 20 N of the hand's spring to where the points are one
    const MechanismResult r = this->rig.step(Vec3(x, 0.0, 0.0));
    EXPECT_EQ(r.eventCount, 0) << x;
    EXPECT_NEAR(r.exact_W.force.x(), kc * x <= 2.0 ? -kc * x : 0.0, 1e-12) << x;
    largestStep_N = std::max(largestStep_N, std::abs(r.wrench_W.force.x() - before_N));
    before_N = r.wrench_W.force.x();
  }
  EXPECT_LE(largestStep_N, 0.25);
  const MechanismResult breaks = this->rig.step(Vec3(2.1e-3, 0.0, 0.0));
  ASSERT_EQ(breaks.eventCount, 1) << "it has held";
  EXPECT_EQ(breaks.events[0].change, ConstraintChange::Broken);
}

TEST_F(Constraints, FrictionSticksWithinItsConeAndSlipsOnIt)
{
  const double mu = 0.4, depth = 2e-3;
  MechanismConstraint& law = this->rig.join(ConstraintKind::Friction, "world", Vec3::Zero(), Vec3::Zero());
  law.axis_B = Vec3::UnitZ();
  law.friction = mu;
  (void)this->rig.step(Vec3(0.0, 0.0, -depth));
  const double normal = kc * depth;
  const double sticksTo = mu * normal / kc;
  const MechanismResult sticks = this->rig.step(Vec3(0.6 * sticksTo, -0.6 * sticksTo, -depth));
  EXPECT_NEAR(sticks.wrench_W.force.x(), -kc * 0.6 * sticksTo, 1e-12);
  EXPECT_NEAR(sticks.wrench_W.force.y(), kc * 0.6 * sticksTo, 1e-12);
  EXPECT_EQ(sticks.laws[0].phase, ConstraintPhase::Closed);
  const Vec3 along = Vec3(3.0, 4.0, 0.0) / 5.0;
  const MechanismResult slips = this->rig.step(Vec3(0.02 * along - depth * Vec3::UnitZ()));
  EXPECT_NEAR(slips.wrench_W.force.head<2>().norm(), mu * normal, 1e-12);
  EXPECT_EQ(slips.laws[0].phase, ConstraintPhase::Slips);
  EXPECT_LE(slips.residual_u, 1e-15);
  // It rests as far behind the hand as friction holds: back by twice that it pulls the other way.
  const Vec3 hand(0.02 * along - depth * Vec3::UnitZ());
  const Vec3 pull = slips.wrench_W.force.head<2>().homogeneous().cwiseProduct(Vec3(1.0, 1.0, 0.0)) / (mu * normal);
  const MechanismResult back = this->rig.step(Vec3(hand + 1.5 * sticksTo * pull));
  EXPECT_LE((back.wrench_W.force - Vec3(-0.5 * mu * normal * pull + normal * Vec3::UnitZ())).norm(), 1e-12);
}

TEST_F(Constraints, DryFrictionHoldsUpToItsForceHoweverHardTheRodIsPressed)
{
  const double c = 0.4;
  MechanismConstraint& law = this->rig.join(ConstraintKind::DryFriction, "world", Vec3::Zero(), Vec3::Zero());
  law.axis_B = Vec3::UnitX();
  law.dryFriction_N = c;
  (void)this->rig.step(Vec3(0.0, 0.0, 0.0));
  const auto felt = [this](double x, double z) { return this->rig.step(Vec3(x, 0.0, z)).wrench_W.force.x(); };
  EXPECT_NEAR(felt(0.3e-3, 0.0), -0.3, 1e-12);
  EXPECT_NEAR(felt(5e-3, 0.1), -c, 1e-12);
  EXPECT_NEAR(felt(5e-3 - 0.5e-3, 0.0), -c + 0.5, 1e-12); // back by half a millimetre
  EXPECT_NEAR(felt(5e-3 - 1.5e-3, 0.0), c, 1e-12);
}

TEST_F(Constraints, ASpringIsInSeriesWithTheHand)
{
  const double k = 300.0, rest = 1e-3;
  MechanismConstraint& law = this->rig.join(ConstraintKind::Spring, "world", Vec3::Zero(), Vec3::Zero());
  law.axis_B = Vec3::UnitY();
  law.stiffness_N_per_u = k;
  law.rest_u = rest;
  for (const double y : { -4e-3, 0.0, 1e-3, 6e-3 })
  {
    const MechanismResult& r = this->rig.step(Vec3(0.0, y, 0.0));
    EXPECT_NEAR(r.wrench_W.force.y(), -(y - rest) / (1.0 / kc + 1.0 / k), 1e-12);
    EXPECT_NEAR(r.stored_Nu, 0.5 * (y - rest) * (y - rest) / (1.0 / kc + 1.0 / k), 1e-15);
  }
}

TEST_F(Constraints, ALimitIsFreeBetweenItsStopsAndSpringsBackBeyond)
{
  const double k = 2000.0;
  MechanismConstraint& law = this->rig.join(ConstraintKind::Limit, "world", Vec3::Zero(), Vec3::Zero());
  law.axis_B = Vec3::UnitX();
  law.stiffness_N_per_u = k;
  law.least_u = -2e-3;
  law.most_u = 3e-3;
  const auto felt = [this](double x) { return this->rig.step(Vec3(x, 0.0, 0.0)).wrench_W.force.x(); };
  const double series = 1.0 / (1.0 / kc + 1.0 / k);
  EXPECT_EQ(felt(1e-3), 0.0);
  EXPECT_NEAR(felt(5e-3), -series * 2e-3, 1e-12);
  EXPECT_NEAR(felt(-3e-3), series * 1e-3, 1e-12);
}

TEST_F(Constraints, APoseThatIsNoneGivesNoForceAndChangesNothing)
{
  this->rig.join(ConstraintKind::Attachment, "world", Vec3::Zero(), Vec3::Zero());
  (void)this->rig.step(Vec3(1e-3, 0.0, 0.0));
  const MechanismResult& none = this->rig.step(Vec3(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0));
  EXPECT_EQ(none.wrench_W.force.norm(), 0.0);
  EXPECT_NEAR(this->rig.step(Vec3(1e-3, 0.0, 0.0)).wrench_W.force.x(), -1.0, 1e-12);
}

TEST_F(Constraints, ABodyThatIsDeletedWhileItIsJoinedLetsGo)
{
  this->rig.addSoft("wall", springWall("wall", Vec3::Zero(), Vec3::UnitZ(), 0.02, 1.0 / tissue));
  this->rig.join(ConstraintKind::Attachment, "wall", Vec3::Zero(), Vec3::Zero());
  EXPECT_GT(this->rig.step(Vec3(1e-3, 0.0, 0.0)).wrench_W.force.norm(), 0.3);
  this->rig.pressed[0] = nullptr;
  const MechanismResult& gone = this->rig.step(Vec3(1e-3, 0.0, 0.0));
  EXPECT_EQ(gone.wrench_W.force.norm(), 0.0);
  EXPECT_EQ(gone.rows, 0);
}

} // namespace
} // namespace palpate::test
