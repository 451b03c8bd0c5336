// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <numbers>

#include "haptics/tool/motion/Turn.h"
#include "testing/oracles/statics/HeldRod.h"
#include "testing/support/CostSample.h"
#include "testing/support/MechanismRig.h"
#include "testing/support/Random.h"

namespace palpate::lab
{

/// By how much a constraint missed the statics of finite turns, over all trials.
struct ConstraintMisses
{
  double force_N = 0.0; ///< of the force, and of the moment at the end of the rod
  double residual_u = 0.0;
  test::CostSample cost{ 0 };
};

/// A rod in a hand: stiff, long and turned at random, and maybe a tissue at random before its tip. The truth is where
/// the energy of the hand's springs, of the tissue and of the constraint is stationary, for turns of any size.
class ConstraintTrial
{
public:
  using Coordinates = test::FiniteStatics::Coordinates;

  test::Random& random;
  const double length_u = this->random.uniform(0.05, 0.25);
  const double yield_u_per_N = 1.0 / this->random.uniform(100.0, 2000.0); ///< of the tissue
  const Quat turn = turnBy(this->random.uniform(0.0, std::numbers::pi) * this->random.direction());
  const Vec3 rod_W = this->turn * Vec3::UnitZ();
  const Vec3 tip_A = this->length_u * Vec3::UnitZ();
  const Vec3 arm_W = this->length_u * this->rod_W; ///< from the hand to the tip
  test::MechanismRig rig{ length_u };

  ConstraintTrial(test::Random& numbers, ConstraintMisses& misses) : random(numbers), misses_(misses)
  {
    this->rig.grip = { this->random.uniform(300.0, 3000.0), this->random.uniform(0.5, 5.0) };
  }

  /// The tip's constraint with another body, which holds where the hand is in the origin.
  MechanismConstraint& joinTip(ConstraintKind kind, const std::string& b, const Vec3& axis_W)
  {
    MechanismConstraint& law = this->rig.join(kind, b, this->tip_A, this->arm_W);
    law.axis_B = axis_W;
    return law;
  }

  void addTissue(const Vec3& centre_W, const Vec3& normal_W)
  {
    this->rig.addSoft("tissue", test::springWall("tissue", centre_W, normal_W, 0.02, this->yield_u_per_N));
  }

  /// Of a point of the rod, as the hand's spring and its turn let it yield at first [u/N].
  [[nodiscard]] double yieldAlong(const Vec3& along_W, const Vec3& lever_W) const
  {
    const MechanismGrip& grip = this->rig.grip;
    return 1.0 / grip.coupling_N_per_u + lever_W.cross(along_W).squaredNorm() / grip.turning_Nu_per_rad;
  }

  /// A force at the tip that falls short of the one that folds the rod in its hand (turning / length): there is one
  /// place of rest near by.
  [[nodiscard]] double safe_N() const { return 0.4 * this->rig.grip.turning_Nu_per_rad / this->length_u; }
  /// So far the hand goes along each axis with no more than half of that; at most some millimetres.
  [[nodiscard]] double way_u() const { return std::min(5e-3, 0.25 * this->safe_N() / this->rig.grip.coupling_N_per_u); }
  /// A hand somewhere near the origin, turned by up to so much about each axis.
  [[nodiscard]] Pose anyHand(double way_u, double turn_rad = 0.1)
  {
    return { this->random.inCube(way_u), turnBy(this->random.inCube(turn_rad)) * this->turn };
  }
  [[nodiscard]] Vec3 tipOf(const Pose& hand_W) const { return hand_W.p + hand_W.q * this->tip_A; }

  /// And where it is with the rod at these coordinates.
  [[nodiscard]] Vec3 tipAt(const Pose& hand_W, const Eigen::VectorXd& z) const
  {
    return z.head<3>() + turnBy(z.segment<3>(3)) * (hand_W.q * this->tip_A);
  }
  /// Coordinates of a rod that is pressed back along itself and does not turn.
  [[nodiscard]] Eigen::VectorXd restStraight(const Pose& hand_W, double push_N) const
  {
    Eigen::VectorXd z = Eigen::VectorXd::Zero(6);
    z.head<3>() = hand_W.p - push_N / this->rig.grip.coupling_N_per_u * this->rod_W;
    return z;
  }

  /// The rod in that hand, with nothing that joins it.
  [[nodiscard]] test::HeldRod rodIn(const Pose& hand_W) const
  {
    return { hand_W.p, hand_W.q, this->rig.grip.coupling_N_per_u, this->rig.grip.turning_Nu_per_rad };
  }

  /// Coordinates of rest with `law` added to the energy of the rod: the rod's six, then `more` of the constraint's own.
  /// Goes on from those that it found before.
  template<class Constraint>
  const Eigen::VectorXd& rest(const Pose& hand_W, int more, const Constraint& law)
  {
    const test::HeldRod rod = this->rodIn(hand_W);
    if (this->z_.size() != 6 + more)
    {
      this->z_.setZero(6 + more);
    }
    const auto energy = [&](const Coordinates& z) { return rod.energy(z) + law(rod, z); };
    if (!test::FiniteStatics::makeStationary(energy, this->z_))
    {
      throw std::runtime_error("the statics of a trial have no end");
    }
    return this->z_;
  }
  /// Where the constraint's own coordinates begin anew.
  void beginAt(const Eigen::VectorXd& own)
  {
    this->z_.setZero(6 + own.size());
    this->z_.tail(own.size()) = own;
  }

  /// A tick with the hand there, and the expected force: that of the rod at these coordinates on the hand.
  void expect(const Pose& hand_W, const Eigen::VectorXd& z)
  {
    const test::HeldRod rod = this->rodIn(hand_W);
    this->expect(hand_W, Wrench{ rod.force(z), rod.moment(z) });
  }
  void expectNothing(const Pose& hand_W) { this->expect(hand_W, Wrench{}); }

private:
  void expect(const Pose& hand_W, const Wrench& truth_W)
  {
    if (!this->planned_)
    {
      this->rig.plan(); // else its cost were the first tick's
      this->planned_ = true;
    }
    const MechanismResult* r = nullptr;
    this->misses_.cost.time([&] { r = &this->rig.step(hand_W); });
    const double moment_N = (r->exact_W.torque - truth_W.torque).norm() / this->length_u;
    this->misses_.force_N = std::max({ this->misses_.force_N, (r->exact_W.force - truth_W.force).norm(), moment_N });
    this->misses_.residual_u = std::max(this->misses_.residual_u, r->residual_u);
  }

  ConstraintMisses& misses_;
  Eigen::VectorXd z_;
  bool planned_ = false;
};

} // namespace palpate::lab
