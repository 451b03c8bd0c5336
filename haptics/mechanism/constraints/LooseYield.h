// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <type_traits>

#include "haptics/mechanism/MechanismPlan.h"
#include "haptics/tool/motion/TargetMotion.h"

namespace palpate
{

/// The motion of a loose body between ticks.
struct LooseMotion
{
  Vec3 speed_W = Vec3::Zero(); ///< of its centre [u/s]
  Vec3 spin_B = Vec3::Zero();  ///< in its own frame [rad/s]
  double calm_s = 0.0;         ///< so long it has hardly moved
  bool asleep = false;         ///< it stays where it is until a force moves it
  bool lost = false;           ///< it has left the scene, and sleeps for good
};

template<class Visit, class Motion>
void membersOf(const Visit& visit, Motion& motion) requires std::is_same_v<std::remove_const_t<Motion>, LooseMotion>
{
  visit(motion.speed_W);
  visit(motion.spin_B);
  visit(motion.calm_s);
  visit(motion.asleep);
  visit(motion.lost);
}

/// How a loose body goes in a tick under the constraints' forces, from where it was: compliance force + back, whitened.
/// An implicit Euler step M (u / dt - v) = dt (f + load), solved for the motion u: M / dt^2 has an inverse, so that the
/// six degrees of freedom are eliminated from the problem of the constraints, and add to the rows' compliance like the
/// springs of the hand do.
struct LooseYield
{
  using Square = Eigen::Matrix<double, 6, 6>;

  Square compliance = Square::Zero(); ///< dt^2 M^-1 [u/N], symmetric, positive definite; 0: it does not move
  Vec6 back_u = Vec6::Zero();         ///< without the constraints' forces
};

/// Gyroscopic moments are an implicit step in the body's frame, which adds no energy. Real-time safe.
[[nodiscard]] LooseYield yieldOfLoose(
  const PlannedBody& body, const Quat& q_W, const LooseMotion& motion, double characteristic_u, double dt_s) noexcept;

/// The motion after a tick in which the body went by `way_u`, whitened, from a pose. A body sleeps after a while of
/// hardly any motion, or `away_u` from where it began, and wakes where the tick moves it by more than rounding.
/// Real-time safe.
struct LooseStep
{
  Vec6 way_u = Vec6::Zero();
  Quat q_W = Quat::Identity(); ///< before the tick
  double away_u = 0.0;
};
[[nodiscard]] LooseMotion motionAfter(const MechanismPlan& plan, const PlannedBody& body, const LooseMotion& before,
  const LooseStep& step, double dt_s) noexcept;

} // namespace palpate
