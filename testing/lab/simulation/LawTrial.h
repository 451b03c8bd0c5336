// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <numbers>

#include "haptics/tool/motion/Turn.h"
#include "testing/support/CostSample.h"
#include "testing/support/MechanismRig.h"
#include "testing/support/Random.h"

namespace palpate::lab
{

/// By how much a law missed its closed form, over all trials.
struct LawMisses
{
  double force_N = 0.0; ///< of the force, and of the moment at the end of the rod
  double residual_u = 0.0;
  test::CostSample cost{ 0 };
};

/// A rod in a hand: stiff, long and turned at random, and maybe a tissue at random before its tip.
class LawTrial
{
public:
  test::Random& random;
  const double length_u = this->random.uniform(0.05, 0.25);
  const double yield_u_per_N = 1.0 / this->random.uniform(100.0, 2000.0); ///< of the tissue
  const Quat turn = turnBy(this->random.uniform(0.0, std::numbers::pi) * this->random.direction());
  const Vec3 rod_W = this->turn * Vec3::UnitZ();
  const Vec3 arm_W = this->length_u * this->rod_W; ///< from the hand to the tip
  test::MechanismRig rig{ length_u };

  LawTrial(test::Random& numbers, LawMisses& misses) : random(numbers), misses_(misses)
  {
    // The closed forms are those of a rod that leans next to nothing.
    this->rig.grip = { this->random.uniform(300.0, 3000.0), 1e7 * this->random.uniform(0.5, 5.0) };
  }

  /// The tip's law with another body, which holds where the hand is in the origin.
  MechanismLaw& joinTip(LawKind kind, const std::string& b, const Vec3& axis_W)
  {
    MechanismLaw& law = this->rig.join(kind, b, this->length_u * Vec3::UnitZ(), this->arm_W);
    law.axis_B = axis_W;
    return law;
  }

  void addTissue(const Vec3& centre_W, const Vec3& normal_W)
  {
    this->rig.addSoft("tissue", test::springWall("tissue", centre_W, normal_W, 0.02, this->yield_u_per_N));
  }

  /// Of a point of the rod, as the hand's spring and its turn let it yield [u/N].
  [[nodiscard]] double yieldAlong(const Vec3& along_W, const Vec3& lever_W) const
  {
    const MechanismGrip& grip = this->rig.grip;
    return 1.0 / grip.coupling_N_per_u + lever_W.cross(along_W).squaredNorm() / grip.turning_Nu_per_rad;
  }

  /// A tick with the hand there, and what it should feel.
  void expect(const Vec3& hand_W, const Wrench& truth_W)
  {
    if (!this->planned_)
    {
      this->rig.plan(); // else its cost were the first tick's
      this->planned_ = true;
    }
    const MechanismResult* r = nullptr;
    this->misses_.cost.time([&] { r = &this->rig.step(Pose{ hand_W, this->turn }); });
    const double moment_N = (r->exact_W.torque - truth_W.torque).norm() / this->length_u;
    this->misses_.force_N = std::max({ this->misses_.force_N, (r->exact_W.force - truth_W.force).norm(), moment_N });
    this->misses_.residual_u = std::max(this->misses_.residual_u, r->residual_u);
  }
  void expectAtTip(const Vec3& hand_W, const Vec3& force_W)
  {
    this->expect(hand_W, { force_W, this->arm_W.cross(force_W) });
  }

private:
  LawMisses& misses_;
  bool planned_ = false;
};

/// What rubs with at most so much rests behind the hand by what that force bends.
inline Vec3 rub(const Vec3& hand_W, double yield_u_per_N, double most_N, Vec3& rest_W)
{
  Vec3 force_W = (rest_W - hand_W) / yield_u_per_N;
  if (const double force_N = force_W.norm(); force_N > most_N)
  {
    force_W *= most_N / force_N;
  }
  rest_W = hand_W + yield_u_per_N * force_W;
  return force_W;
}

} // namespace palpate::lab
