// SPDX-License-Identifier: GPL-3.0-or-later
// A block that nothing but the balance of forces holds stands on four springs with friction, and a needle pushes it.
#include <cmath>
#include <tuple>

#include <gtest/gtest.h>

#include "haptics/tool/motion/Turn.h"
#include "testing/oracles/statics/HeldRod.h"
#include "testing/support/MechanismRig.h"

namespace palpate::test
{
namespace
{

constexpr double pusher = 0.1, halfBlock = 0.05, springOfFoot = 2000.0, weightOfBlock = 2.0;
constexpr double onHand = 1.0 / kc, onFeet = 0.25 / springOfFoot; // m/N

class Rubbing : public testing::Test
{
protected:
  /// The block of that half height, pushed by a needle along x at `height` above its feet.
  void stand(double halfHeight, double friction, double height, const Vec3& load_W = Vec3(0.0, 0.0, -weightOfBlock))
  {
    MechanismBody block;
    block.name = "block";
    block.kind = MechanismBodyKind::Rigid;
    block.halfSize_u = Vec3(halfBlock, halfBlock, halfHeight);
    block.load_W = load_W;
    this->rig.grip = { kc, kr };
    this->rig.mechanism.bodies.push_back(block);
    for (int foot = 0; foot < 4; ++foot)
    {
      const Vec3 at(foot & 1 ? halfBlock : -halfBlock, foot & 2 ? halfBlock : -halfBlock, -halfHeight);
      const std::string name = "foot " + std::to_string(foot);
      this->rig.addSoft(name, springWall(name, at, Vec3::UnitZ(), 0.01, 1.0 / springOfFoot));
      MechanismConstraint& law = this->rig.join(ConstraintKind::Friction, name, at, at);
      law.a = "block";
      law.axis_B = Vec3::UnitZ();
      law.friction = friction;
    }
    this->pushed = Vec3(-halfBlock, 0.0, height - halfHeight);
    MechanismConstraint& push = this->rig.join(ConstraintKind::Contact, "block", Vec3(0.0, 0.0, pusher), this->pushed);
    push.axis_B = -Vec3::UnitX();
    ASSERT_TRUE(this->rig.check().faults.empty()) << this->rig.check().faults.front();
  }

  /// The hand leads the needle's tip so far into the block as it stood.
  const MechanismResult& lead(double depth)
  {
    const Quat alongX(Eigen::AngleAxisd(0.5 * M_PI, Vec3::UnitY()));
    const MechanismResult& r = this->rig.step(Pose{ this->pushed + Vec3(depth - pusher, 0.0, 0.0), alongX });
    EXPECT_FALSE(r.capped);
    EXPECT_LE(r.residual_u, 1e-15);
    EXPECT_TRUE(this->balance(r).isZero(1e-12)) << this->balance(r).transpose();
    this->before_W = this->blockOf(r);
    return r;
  }

  /// Of all that acts on the block, and its moment about the block's place.
  [[nodiscard]] Vec6 balance(const MechanismResult& r) const
  {
    Vec6 sum;
    sum << this->rig.mechanism.bodies[block_].load_W, Vec3::Zero();
    for (std::size_t l = 0; l < this->rig.mechanism.laws.size(); ++l)
    {
      const bool foot = l < 4;
      const Vec3 force_N = foot ? r.laws[l].force_W : Vec3(-r.laws[l].force_W);
      const Vec3 arm = foot ? this->rig.mechanism.laws[l].point_A : this->pushed;
      sum += (Vec6() << force_N, (this->before_W.q * arm).cross(force_N)).finished();
    }
    return sum;
  }

  [[nodiscard]] static double pushOf(const MechanismResult& r) { return -r.exact_W.force.x(); }
  [[nodiscard]] const Pose& blockOf(const MechanismResult& r) const { return r.pose_W[block_]; }

  static constexpr std::size_t block_ = 2; // after needle and world
  MechanismRig rig{ pusher };
  Vec3 pushed = Vec3::Zero();
  Pose before_W; ///< of the block, where its constraints are taken
};

TEST_F(Rubbing, ABlockThatIsPushedSticksUntilAllFrictionIsUsedUpThenSlidesAndStaysWhereItCame)
{
  const double friction = 0.3, most_N = friction * weightOfBlock;
  this->stand(0.02, friction, 0.0); // at its feet: no foot is lightened
  const MechanismResult stands = this->lead(-1e-3);
  EXPECT_NEAR(this->blockOf(stands).p.z(), -weightOfBlock * onFeet, 1e-15);

  const double held_N = 0.8 * most_N;
  const MechanismResult sticks = this->lead(held_N * (onHand + onFeet));
  EXPECT_NEAR(this->pushOf(sticks), held_N, 1e-12);
  EXPECT_NEAR(this->blockOf(sticks).p.x(), held_N * onFeet, 1e-15);
  for (std::size_t foot = 0; foot < 4; ++foot)
  {
    EXPECT_EQ(sticks.laws[foot].phase, ConstraintPhase::Closed);
    EXPECT_LE((sticks.laws[foot].force_W - Vec3(-0.25 * held_N, 0.0, 0.25 * weightOfBlock)).norm(), 1e-12);
  }
  EXPECT_NEAR(this->blockOf(this->lead(-1e-3)).p.x(), 0.0, 1e-15) << "it has not slipped";

  const double depth = 0.01, slipped = depth - most_N * (onHand + onFeet);
  for (int i = 1; i < 20; ++i) // by pieces it comes to the same
  {
    (void)this->lead(depth * i / 20);
  }
  const MechanismResult slides = this->lead(depth);
  EXPECT_NEAR(this->pushOf(slides), most_N, 1e-12);
  EXPECT_NEAR(this->blockOf(slides).p.x(), slipped + most_N * onFeet, 1e-14);
  for (std::size_t foot = 0; foot < 4; ++foot)
  {
    EXPECT_EQ(slides.laws[foot].phase, ConstraintPhase::Slips);
    EXPECT_LE((slides.laws[foot].force_W - Vec3(-0.25 * most_N, 0.0, 0.25 * weightOfBlock)).norm(), 1e-12);
  }
  const MechanismResult left = this->lead(-1e-3);
  EXPECT_EQ(this->pushOf(left), 0.0);
  EXPECT_NEAR(this->blockOf(left).p.x(), slipped, 1e-14);
}

TEST_F(Rubbing, ABlockThatIsPushedHighTipsBeforeItSlidesAndItsFeetBehindOpenExactly)
{
  const double height = 0.2, friction = 0.9;
  const double tips_N = weightOfBlock * halfBlock / height; // about its feet in front
  ASSERT_LT(tips_N, friction * weightOfBlock);
  this->stand(0.1, friction, height);
  (void)this->lead(-1e-3);
  // Those in front stick: D = F / kc + F / 2k + turn height.
  const double depth = 4e-3;
  const MechanismResult& r = this->lead(depth);
  const double turn = (depth - tips_N * (onHand + 2.0 * onFeet)) / height;
  const double gap = 2.0 * turn * halfBlock - weightOfBlock * 2.0 * onFeet;
  ASSERT_GT(gap, 1e-4);
  EXPECT_NEAR(this->pushOf(r), tips_N, 1e-12);
  EXPECT_LE((rotationVector(this->blockOf(r).q) - turn * Vec3::UnitY()).norm(), 1e-13);
  for (std::size_t foot = 0; foot < 4; ++foot)
  {
    const bool front = foot & 1;
    const Vec3 expected_N = front ? Vec3(-0.5 * tips_N, 0.0, 0.5 * weightOfBlock) : Vec3(Vec3::Zero());
    EXPECT_LE((r.laws[foot].force_W - expected_N).norm(), front ? 1e-12 : 0.0) << foot;
    EXPECT_EQ(r.laws[foot].phase, front ? ConstraintPhase::Closed : ConstraintPhase::Open);
  }
}

TEST_F(Rubbing, OnLessFrictionTheSameBlockSlidesBeforeItTipsAndPressesMoreOnItsFeetInFront)
{
  const double height = 0.2, friction = 0.2, most_N = friction * weightOfBlock;
  ASSERT_LT(most_N, weightOfBlock * halfBlock / height);
  this->stand(0.1, friction, height);
  (void)this->lead(-1e-3);
  const MechanismResult& r = this->lead(8e-3);
  EXPECT_NEAR(this->pushOf(r), most_N, 1e-12);
  for (std::size_t foot = 0; foot < 4; ++foot)
  {
    const double moment = most_N * height / (4.0 * halfBlock);
    const double normal_N = 0.25 * weightOfBlock + (foot & 1 ? moment : -moment);
    EXPECT_NEAR(r.laws[foot].force_W.z(), normal_N, 1e-12);
    EXPECT_NEAR(r.laws[foot].force_W.x(), -friction * normal_N, 1e-12);
    EXPECT_EQ(r.laws[foot].phase, ConstraintPhase::Slips);
  }
}

TEST_F(Rubbing, OnASlopeThatItsFrictionHoldsABlockNeverCreeps)
{
  const double slope = 0.2, friction = 0.3, middle = 0.02, pulls_N = weightOfBlock * std::sin(slope);
  this->stand(middle, friction, 0.0, weightOfBlock * Vec3(std::sin(slope), 0.0, -std::cos(slope)));
  // The foot that bears least sticks.
  ASSERT_LT(pulls_N, friction * (weightOfBlock * std::cos(slope) - pulls_N * middle / halfBlock));
  // It leans as far as the moment about its feet has it.
  const double leans = 1.0 + middle * middle / (halfBlock * halfBlock);
  EXPECT_NEAR(this->blockOf(this->lead(-1e-2)).p.x(), leans * pulls_N * onFeet, 1e-15);
  for (int tick = 0; tick < 20; ++tick) // its arms are those of where it was
  {
    (void)this->lead(-1e-2);
  }
  const Pose settled = this->before_W;
  for (int tick = 0; tick < 300; ++tick)
  {
    (void)this->lead(-1e-2);
  }
  EXPECT_LE((this->before_W.p - settled.p).norm(), 1e-15);
  EXPECT_LE((this->before_W.q.coeffs() - settled.q.coeffs()).norm(), 1e-14);
}

TEST_F(Rubbing, WhereNoPlaceIsOneOfRestATickSaysSoAndTheBlockGoesNoFurtherThanItsLoadMakesIt)
{
  const double slope = 0.4, friction = 0.3;
  const Vec3 load_W = weightOfBlock * Vec3(std::sin(slope), 0.0, -std::cos(slope));
  this->stand(0.02, friction, 0.0, load_W);
  const double pulls_N = load_W.x() + friction * load_W.z();
  ASSERT_GT(pulls_N, 0.0);
  const Quat alongX(Eigen::AngleAxisd(0.5 * M_PI, Vec3::UnitY()));
  const auto lead = [&](double depth) -> const MechanismResult& {
    return this->rig.step(Pose{ this->pushed + Vec3(depth - pusher, 0.0, 0.0), alongX });
  };
  double last = 0.0;
  for (int tick = 0; tick < 100; ++tick)
  {
    const MechanismResult& r = lead(-1e-2);
    const double x = this->blockOf(r).p.x();
    EXPECT_TRUE(r.capped) << tick;
    EXPECT_TRUE(r.exact_W.force.allFinite());
    EXPECT_EQ(r.exact_W.force.norm(), 0.0) << "nothing of it is felt by a hand that does not touch";
    EXPECT_LE(x - last, weightOfBlock / kc);
    EXPECT_GT(x - last, 0.0);
    last = x;
  }
  // A needle in its way bears the load beyond the friction.
  this->rig.mechanism.laws.pop_back();
  const Vec3 front(halfBlock, 0.0, -0.02);
  this->rig.join(ConstraintKind::Contact, "block", Vec3(0.0, 0.0, pusher), front).axis_B = Vec3::UnitX();
  this->rig.plan();
  const Quat againstX(Eigen::AngleAxisd(-0.5 * M_PI, Vec3::UnitY()));
  const MechanismResult& held = this->rig.step(Pose{ front + pusher * Vec3::UnitX(), againstX });
  EXPECT_FALSE(held.capped);
  EXPECT_NEAR(held.exact_W.force.x(), pulls_N, 1e-12);
}

TEST_F(Rubbing, WhatSlidesWithoutEndIsFoundOutInAShareOfTheWorkAndGoesAsItWouldWithoutThat)
{
  for (const double slope : { 0.32, 0.4, 0.7 })
  {
    SCOPED_TRACE(slope);
    this->rig = MechanismRig(pusher);
    this->stand(0.02, 0.3, 0.0, weightOfBlock * Vec3(std::sin(slope), 0.0, -std::cos(slope)));
    const Quat alongX(Eigen::AngleAxisd(0.5 * M_PI, Vec3::UnitY()));
    Vec3 before_W = Vec3::Zero();
    for (int tick = 0; tick < 50; ++tick)
    {
      const MechanismResult& r = this->rig.step(Pose{ this->pushed - Vec3(1e-2 + pusher, 0.0, 0.0), alongX });
      EXPECT_TRUE(r.capped) << tick;
      EXPECT_LE(10 * r.work, lawWorkBudget) << tick;
      // The step of the drag, which has the compliance of the hand's spring: it goes by the load that its feet do not
      // bear.
      Vec3 left_N = this->rig.mechanism.bodies[block_].load_W;
      for (std::size_t foot = 0; foot < 4; ++foot)
      {
        left_N += r.laws[foot].force_W;
      }
      EXPECT_LE((this->blockOf(r).p - before_W - left_N / kc).norm(), 1e-15) << tick;
      before_W = this->blockOf(r).p;
    }
  }
}

/// A rod stands on a floor with friction, and its hand goes aside.
MechanismResult standAside(double turning_Nm_per_rad, double friction, double depth, double aside)
{
  const Vec3 tipAt(0.0, 0.0, pusher);
  MechanismRig rig(pusher);
  rig.grip = { kc, turning_Nm_per_rad };
  rig.addSoft("floor", springWall("floor", tipAt, -Vec3::UnitZ(), 0.02, 1.0 / springOfFoot));
  MechanismConstraint& law = rig.join(ConstraintKind::Friction, "floor", tipAt, tipAt);
  law.axis_B = -Vec3::UnitZ();
  law.friction = friction;
  EXPECT_TRUE(rig.check().faults.empty());
  (void)rig.step(Vec3(0.0, 0.0, depth));
  return rig.step(Vec3(aside, 0.0, depth));
}

/// Where such a rod leans to rest in a hand that turns it: coordinates of the finite turn, the friction along x, and
/// whether it slips. Before, the hand had it straight above its tip.
std::tuple<Eigen::VectorXd, double, bool> restAside(double friction, double depth, double aside)
{
  const Vec3 tipAt(0.0, 0.0, pusher);
  const HeldRod rod{ Vec3(aside, 0.0, depth), Quat::Identity(), kc, kr };
  Eigen::VectorXd z = Eigen::VectorXd::Zero(7);
  const auto under = [&](const Vec3& rubs)
  {
    const auto energy = [&](const FiniteStatics::Coordinates& c)
    {
      const JetVector apart = rod.point(c, tipAt) - tipAt;
      const Jet push = kc * c[6];
      return rod.energy(c) + push * apart.z - 0.5 / springOfFoot * push * push - dot(rubs, apart);
    };
    EXPECT_TRUE(FiniteStatics::makeStationary(energy, z));
    const Vec3 tip = z.head<3>() + turnBy(z.segment<3>(3)) * tipAt;
    const Vec3 slip(tip.x() + rubs.x() / springOfFoot, tip.y() + rubs.y() / springOfFoot, 0.0);
    return Rubbed{ slip, friction * kc * z[6] };
  };
  const Vec3 rubs = frictionAt(Vec3::Zero(), 1.0 / kc + pusher * pusher / kr + 1.0 / springOfFoot, under);
  const double most = under(rubs).most;
  return { z, rubs.x(), rubs.norm() > (1.0 - 1e-9) * most };
}

TEST(RubbingRod, WhoseTurnIsFreePushesOnlyAlongItselfAndOneThatIsTurnedIsHeldAsideUpToItsFriction)
{
  const double depth = 2e-3, friction = 0.4;
  const double pushes_N = depth / (1.0 / kc + 1.0 / springOfFoot);
  for (const double aside : { 1e-3, 5e-3 })
  {
    const MechanismResult free = standAside(0.0, friction, depth, aside);
    EXPECT_FALSE(free.capped);
    EXPECT_LE((free.exact_W.force + pushes_N * Vec3::UnitZ()).norm(), 1e-12) << "no moment holds it aside";
    EXPECT_LE(free.exact_W.torque.norm(), 1e-13);
    const MechanismResult turned = standAside(kr, friction, depth, aside);
    const auto [z, rubs_N, slips] = restAside(friction, depth, aside);
    const HeldRod rod{ Vec3(aside, 0.0, depth), Quat::Identity(), kc, kr };
    EXPECT_LE((turned.exact_W.force - rod.force(z)).norm(), 1e-11);
    EXPECT_LE((turned.exact_W.torque - rod.moment(z)).norm(), 1e-12);
    EXPECT_NEAR(turned.exact_W.force.x(), rubs_N, 1e-11);
    EXPECT_EQ(turned.laws[0].phase, slips ? ConstraintPhase::Slips : ConstraintPhase::Closed);
  }
}

} // namespace
} // namespace palpate::test
