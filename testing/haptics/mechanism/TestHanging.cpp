// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies that turn freely between joints: a rod in the hand on a drawer, and on a door [mm, N, N/mm].
#include <cmath>

#include <gtest/gtest.h>

#include "testing/support/MechanismRig.h"

namespace palpate::test
{
namespace
{

constexpr double hangingCoupling = 0.5, rodLength = 20.0;

class Hanging : public testing::Test
{
protected:
  Hanging() { this->rig.grip = { hangingCoupling, 0.0 }; }

  void addBody(const std::string& name, const Vec3& halfSize, const Vec3& at)
  {
    MechanismBody body;
    body.name = name;
    body.kind = MechanismBodyKind::Rigid;
    body.halfSize_u = halfSize;
    body.pose_W.p = at;
    this->rig.mechanism.bodies.push_back(body);
  }

  MechanismConstraint& join(ConstraintKind kind, const Vec3& point_A, const Vec3& point_B, const Vec3& axis)
  {
    MechanismConstraint& law = this->rig.join(kind, "world", point_A, point_B);
    law.a = this->rig.mechanism.bodies.back().name;
    law.axis_A = law.axis_B = axis;
    return law;
  }

  /// Along a straight line, then at rest.
  const MechanismResult& lead(const Vec3& from, const Vec3& to, int ticks)
  {
    for (int i = 0; i < 2 * ticks; ++i)
    {
      const MechanismResult& r = this->rig.step(Vec3(from + std::min(1.0, double(i) / ticks) * (to - from)));
      this->capped_ += r.capped;
      this->residual_u_ = std::max(this->residual_u_, r.residual_u);
      this->jump_N_ = i > 0 ? std::max(this->jump_N_, (r.wrench_W.force - this->force_).norm()) : 0.0;
      this->force_ = r.wrench_W.force;
      this->farthest_u_ = std::max(this->farthest_u_, r.pose_W[2].p.norm());
    }
    return this->rig.step(to);
  }

  MechanismRig rig{ rodLength };
  int capped_ = 0;
  double residual_u_ = 0.0;
  double jump_N_ = 0.0;
  double farthest_u_ = 0.0;
  Vec3 force_ = Vec3::Zero();
};

class HangingDrawer : public Hanging
{
protected:
  static constexpr double away = 30.0, arm = 10.0, felt = 0.6;

  HangingDrawer()
  {
    this->addBody("drawer", Vec3(40.0, 30.0, 10.0), Vec3(0.0, 0.0, away));
    this->rig.join(ConstraintKind::Attachment, "drawer", Vec3(0.0, 0.0, rodLength), Vec3(0.0, 0.0, -arm));
    this->join(ConstraintKind::Slider, Vec3::Zero(), Vec3(0.0, 0.0, away), Vec3::UnitX());
    this->join(ConstraintKind::DryFriction, Vec3::Zero(), Vec3(0.0, 0.0, away), Vec3::UnitX()).dryFriction_N = felt;
  }

  /// Across the rails hand, rod and drawer are one straight line, as nothing there has a moment: as long as the arm,
  /// the rod's share and the hand's spring. The rod leans by the friction of the felt.
  static double pullAcross(double distance)
  {
    double low = 0.0, high = hangingCoupling * distance;
    for (int i = 0; i < 100; ++i)
    {
      const double pull = 0.5 * (low + high);
      const double length = arm + rodLength * pull / std::hypot(pull, felt) + pull / hangingCoupling;
      (length < distance ? low : high) = pull;
    }
    return low;
  }
};

TEST_F(HangingDrawer, IsPulledOutBesideItsRailsAsAStraightLineOfRodAndArmIs)
{
  for (const double y : { 0.0, 1e-3, 0.1, 1.0, 5.0 })
  {
    SCOPED_TRACE(y);
    this->rig.plan();
    this->jump_N_ = 0.0;
    const MechanismResult& r = this->lead(Vec3::Zero(), Vec3(20.0, y, 0.0), 2000);
    EXPECT_EQ(this->capped_, 0);
    EXPECT_LE(this->residual_u_, 1e-12);
    const double distance = std::hypot(away, y);
    const double pull = pullAcross(distance);
    const Vec3 expected(-felt, -pull * y / distance, pull * away / distance);
    EXPECT_LE((r.wrench_W.force - expected).norm(), 1e-9);
    const double lean = rodLength * felt / std::hypot(pull, felt);
    EXPECT_NEAR(r.pose_W[2].p.x(), 20.0 - felt / hangingCoupling - lean, 1e-9);
    // The hand goes .0103 in a tick.
    EXPECT_LE(this->jump_N_, hangingCoupling * 0.0103);
  }
}

class HangingDoor : public Hanging
{
protected:
  static constexpr double half = 40.0;

  HangingDoor()
  {
    this->addBody("door", Vec3(half, 30.0, 2.0), Vec3(half, 0.0, 22.0));
    this->rig.join(ConstraintKind::Attachment, "door", Vec3(0.0, 0.0, rodLength), Vec3(35.0, 0.0, -2.0));
    this->join(ConstraintKind::Hinge, Vec3(-half, 0.0, 0.0), pin, Vec3::UnitY());
  }

  Vec3 pin{ 0.0, 0.0, 22.0 };
};

TEST_F(HangingDoor, GivesWayToAHandThatTheRodReaches)
{
  const MechanismResult& r = this->lead(Vec3(75.0, 0.0, 0.0), Vec3(75.0, 5.0, 0.0), 1000);
  EXPECT_EQ(this->capped_, 0);
  EXPECT_LE(this->residual_u_, 1e-12);
  EXPECT_LE(r.wrench_W.force.norm(), 1e-9);
  EXPECT_NEAR((r.pose_W[2].p - this->pin).norm(), half, 1e-9);
}

TEST_F(HangingDoor, ComesToRestAtAHandThatBeganFarFromItsHandle)
{
  for (const Vec3& hand :
    { Vec3(15.0, 0.0, 0.0), Vec3(75.0, 0.0, -60.0), Vec3(-75.0, 0.0, 5.0), Vec3(300.0, 0.0, 200.0) })
  {
    SCOPED_TRACE(hand.transpose());
    this->rig.plan();
    const MechanismResult& r = this->lead(hand, hand, 1000);
    EXPECT_FALSE(r.capped);
    EXPECT_NEAR((r.pose_W[2].p - this->pin).norm(), half, 1e-9);
    // From the pin a handle's circle, then the rod, then the hand's spring; the rod lies there with its end as well.
    const double handle = std::hypot(75.0, 2.0);
    const double distance = (hand - this->pin).norm();
    const double apart = std::max({ distance - handle - rodLength, handle - rodLength - distance, 0.0 });
    EXPECT_NEAR(r.wrench_W.force.norm(), hangingCoupling * apart, 1e-9);
    EXPECT_LE(this->farthest_u_, 2.0 * half + this->pin.norm());
  }
}

} // namespace
} // namespace palpate::test
