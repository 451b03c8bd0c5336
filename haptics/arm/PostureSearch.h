// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/Cholesky>

#include "haptics/arm/ArmTypes.h"

namespace palpate
{

/// A goal for the tip; without `turn` the orientation is free.
struct ChainGoal
{
  Vec3 p = Vec3::Zero();
  std::optional<Quat> turn;
};

using GoalError = Eigen::Matrix<double, 6, 1>;

/// Error from the tip to the goal: the position in rows 0 .. 2 [m], a goal's rotation in rows 3 .. 5 [m at the lever].
[[nodiscard]] inline GoalError errorOf(const Pose& tip, const ChainGoal& goal, double lever_m) noexcept
{
  GoalError error = GoalError::Zero();
  error.head<3>() = goal.p - tip.p;
  if (goal.turn)
  {
    const Quat left = *goal.turn * tip.q.conjugate();
    error.tail<3>() = 2.0 * lever_m * std::copysign(1.0, left.w()) * left.vec();
  }
  return error;
}

/// Joints for a goal by damped least squares from q (Levenberg 1944) in a bounded number of steps; nothing if the goal
/// is not reached to 1e-13 of the reach. `postureAt(q)`: of the arm; `reach_m`: its size, which weighs the rotation.
template<class PostureAt>
[[nodiscard]] std::optional<JointVector> stepTo(
  const PostureAt& postureAt, double reach_m, const ChainGoal& goal, JointVector q) noexcept
{
  constexpr int mostSteps = 120;
  Posture posture = postureAt(q);
  if (!posture.exists)
  {
    return std::nullopt;
  }
  GoalError error = errorOf(posture.tip, goal, reach_m);
  double damping = 1e-3;
  for (int step = 0; step < mostSteps && error.norm() > 4.0 * std::numeric_limits<double>::epsilon() * reach_m; ++step)
  {
    ArmJacobian jacobian = posture.jacobian;
    jacobian.bottomRows<3>() *= goal.turn ? reach_m : 0.0;
    JointMatrix normal = jacobian.transpose() * jacobian;
    normal.diagonal().array() += damping * reach_m * reach_m;
    const JointVector next = q + normal.ldlt().solve(jacobian.transpose() * error);
    const Posture there = postureAt(next);
    const GoalError left = errorOf(there.tip, goal, reach_m);
    const bool nearer = there.exists && left.norm() < error.norm();
    damping *= nearer ? 0.1 : 10.0;
    if (nearer)
    {
      q = next;
      posture = there;
      error = left;
    }
    else if (damping > 1e6)
    {
      break;
    }
    damping = std::max(damping, 1e-15);
  }
  constexpr double rounding = 1e-13;
  return error.norm() <= rounding * reach_m ? std::optional(q) : std::nullopt;
}

} // namespace palpate
