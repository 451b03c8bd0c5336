// SPDX-License-Identifier: GPL-3.0-or-later
// A rigid rod in the hand through a wall and an organ, docs/theory.md, "Constraints between bodies": lateral, y; the
// rod runs along z. Its numbers are those of small turns, where the hand goes a ten thousandth of its 5 mm; where it
// goes all of them, the statics of the finite turn are the judge.
#include <gtest/gtest.h>

#include "haptics/tool/motion/Turn.h"
#include "testing/support/LeverRig.h"

namespace palpate::test
{
namespace
{

constexpr double wall = 500.0, organ = 200.0, a = 0.05, l = 0.15, small = 1e-4;

class Lever : public testing::Test
{
protected:
  Lever() { addLever(this->rig, this->needle); }

  const NeedleLever needle{ kr, { wall, organ }, { a, l }, kc };
  MechanismRig rig;
};

TEST_F(Lever, TheWallPushesAndTheOrganPullsAsTheSharedComplianceSays)
{
  const double y = 5e-3;
  const MechanismResult& r = this->rig.step(Vec3(0.0, small * y, 0.0));
  const Eigen::Matrix2d j = (Eigen::Matrix2d() << 1.0, a, 1.0, l).finished();
  const Eigen::Matrix2d w = j * Eigen::Vector2d(1.0 / kc, 1.0 / kr).asDiagonal() * j.transpose() +
                            Eigen::Matrix2d(Eigen::Vector2d(1.0 / wall, 1.0 / organ).asDiagonal());
  EXPECT_NEAR(w(0, 0), 4.25e-3, 1e-15);
  const Eigen::Vector2d f = w.inverse() * Eigen::Vector2d(-y, -y);
  EXPECT_NEAR(r.laws[0].force_W.y(), small * f[0], small * 1e-9);
  EXPECT_NEAR(r.laws[1].force_W.y(), small * f[1], small * 1e-9);
  EXPECT_LT(f[0], 0.0);
  EXPECT_GT(f[1], 0.0); // the organ is pulled the other way
  EXPECT_NEAR(f[0], -1.231527, 1e-6);
  EXPECT_NEAR(f[1], 0.049261, 1e-6);
  const Eigen::Vector2d onHand = j.transpose() * f;
  EXPECT_NEAR(r.wrench_W.force.y(), small * onHand[0], small * 1e-9);
  EXPECT_NEAR(r.wrench_W.torque.x(), -small * onHand[1], small * 1e-9); // a push along y at z turns about -x
  EXPECT_NEAR(r.pose_W[0].p.y(), small * (y + onHand[0] / kc), small * 1e-12);
  EXPECT_NEAR(rotationVector(r.pose_W[0].q).x(), -small * onHand[1] / kr, small * 1e-9);
  EXPECT_LE(r.residual_u, 1e-15);
  // By the energy of both springs and the grip instead.
  const Eigen::Matrix2d stiffness = Eigen::Matrix2d(Eigen::Vector2d(kc, kr).asDiagonal()) +
                                    wall * j.row(0).transpose() * j.row(0) + organ * j.row(1).transpose() * j.row(1);
  const Eigen::Vector2d pose = stiffness.inverse() * Eigen::Vector2d(kc * y, 0.0);
  EXPECT_NEAR(r.pose_W[0].p.y(), small * pose[0], small * 1e-12);
  EXPECT_NEAR(rotationVector(r.pose_W[0].q).x(), -small * pose[1], small * 1e-9);
  EXPECT_NEAR(r.stored_Nu, small * small * 0.5 * f.dot(w * f), small * small * 1e-12);
}

TEST_F(Lever, AHandThatGoesFiveMillimetresFeelsTheStaticsOfTheFiniteTurn)
{
  const double hand_m = 5e-3;
  const MechanismResult& r = this->rig.step(Vec3(0.0, hand_m, 0.0));
  const HeldRod rod = this->needle.rod(hand_m);
  const Eigen::VectorXd z = this->needle.rest(hand_m);
  ASSERT_GT(z.size(), 0);
  // Of the turn up to 1e-11 rad may be left to the next tick: 1.5e-12 m at the organ.
  EXPECT_LE((r.laws[0].force_W + kc * z.segment<3>(7)).norm(), 1e-9);
  EXPECT_LE((r.laws[1].force_W + kc * z.segment<3>(11)).norm(), 1e-9);
  EXPECT_LE((r.wrench_W.force - rod.force(z)).norm(), 1e-9);
  EXPECT_LE((r.wrench_W.torque - rod.moment(z)).norm(), 1e-10);
  EXPECT_LE((r.pose_W[0].p - z.head<3>()).norm(), 1e-12);
  EXPECT_LE((rotationVector(r.pose_W[0].q) - z.segment<3>(3)).norm(), 1e-11);
  // The rows of small turns would be off by the rod's lean.
  EXPECT_NEAR(r.laws[0].force_W.y(), -1.231527, 1e-2);
  EXPECT_GT(std::abs(r.laws[0].force_W.y() + 1.231527), 1e-5);
}

TEST_F(Lever, ADeviceThatLeavesTheTurnFreeFeelsTheBalanceOfMoments)
{
  this->rig.grip.turning_Nu_per_rad = 0.0;
  const double y = 5e-3;
  const MechanismResult& r = this->rig.step(Vec3(0.0, y, 0.0));
  EXPECT_NEAR(r.laws[0].force_W.y(), -10.0 / 9.0, 1e-9);
  EXPECT_NEAR(r.laws[1].force_W.y(), 10.0 / 27.0, 1e-9);
  EXPECT_NEAR(a * r.laws[0].force_W.y() + l * r.laws[1].force_W.y(), 0.0, 1e-12);
  EXPECT_NEAR(-r.wrench_W.force.y() / y, 4000.0 / 27.0, 1e-9 * 148.0);
  EXPECT_NEAR(r.wrench_W.torque.norm(), 0.0, 1e-12);
}

TEST_F(Lever, RedundantHolesChangeNoForceOnTheHand)
{
  const Vec3 hand(0.0, 5e-3, 0.0);
  const MechanismResult alone = this->rig.step(hand);
  MechanismRig twice;
  twice.grip = this->rig.grip;
  twice.mechanism = this->rig.mechanism;
  twice.soft = this->rig.soft;
  twice.pressed = this->rig.pressed;
  twice.join(ConstraintKind::Insertion, "wall", Vec3::Zero(), Vec3(0.0, 0.0, a));
  const MechanismResult& r = twice.step(hand);
  EXPECT_LE((r.wrench_W.force - alone.wrench_W.force).norm(), 1e-12);
  EXPECT_LE((r.wrench_W.torque - alone.wrench_W.torque).norm(), 1e-12);
  EXPECT_EQ(twice.check().redundant, std::vector<std::string>{ "law 2" });
}

} // namespace
} // namespace palpate::test
