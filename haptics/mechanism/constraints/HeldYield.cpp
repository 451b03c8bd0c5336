// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/constraints/HeldYield.h"

#include <algorithm>

#include <Eigen/Cholesky>

#include "haptics/core/CrossMatrix.h"
#include "haptics/tool/motion/Turn.h"

namespace palpate
{
namespace
{

/// Share of the springs' stiffness that is left at least where the second derivatives are taken as they are.
constexpr double leastStiff = 0.1;

/// Half the second derivative of the squared angle between two orientations, along turns of one of them.
Mat3 bendOfAngle(const Quat& from, const Quat& to) noexcept
{
  const Quat turn = to * from.conjugate();
  const double sine = turn.vec().norm();
  if (!(sine > 0.0))
  {
    return Mat3::Identity();
  }
  const Vec3 axis = turn.vec() / sine;
  const double share = 0.5 * rotationVector(turn).norm() * std::abs(turn.w()) / sine;
  return share * Mat3::Identity() + (1.0 - share) * axis * axis.transpose();
}

/// The springs near where the hand has the body and, beside them, how turns and forces change that.
struct Stiffness
{
  HeldYield::Square springs = HeldYield::Square::Zero();
  HeldYield::Square bend = HeldYield::Square::Zero();   ///< of springs that are turned far
  HeldYield::Square forces = HeldYield::Square::Zero(); ///< of the constraints
  double mostOfForces = 0.0;                            ///< an upper bound of the forces' stiffness against turns
  bool turning = false; ///< a direction turns: yield of soft bodies along it is not included

  /// Of a force at an arm that turns with the body, while it keeps its direction.
  void addFixed(const Vec3& force_W, const Vec3& arm_W, double characteristic_u) noexcept
  {
    const Mat3 both = 0.5 * (force_W * arm_W.transpose() + arm_W * force_W.transpose());
    this->forces.bottomRightCorner<3, 3>() +=
      (force_W.dot(arm_W) * Mat3::Identity() - both) / (characteristic_u * characteristic_u);
    this->bound(force_W, arm_W, characteristic_u);
  }

  /// Of a force at a place that stays where it is, while its direction turns with the body.
  void addTurning(const Vec3& force_W, const Vec3& arm_W, double characteristic_u) noexcept
  {
    this->turning = true;
    const Mat3 across = crossMatrix(force_W) / characteristic_u;
    this->addFixed(-force_W, arm_W, characteristic_u);
    this->forces.topRightCorner<3, 3>() += across;
    this->forces.bottomLeftCorner<3, 3>() += across.transpose();
  }

private:
  void bound(const Vec3& force_W, const Vec3& arm_W, double characteristic_u) noexcept
  {
    this->mostOfForces +=
      0.5 * (force_W.norm() * arm_W.norm() + force_W.dot(arm_W)) / (characteristic_u * characteristic_u);
  }
};

void addForces(const ConstraintScene& scene, const ConstraintRows& rows, Stiffness& stiffness) noexcept
{
  for (int l = 0; l < scene.plan.lawCount; ++l)
  {
    for (int side = 0; side < 2 && scene.laws[l].force_W != Vec3::Zero(); ++side)
    {
      if (rows.ends[l][side].body != scene.plan.held)
      {
        continue;
      }
      const Vec3 force_W = side == 0 ? scene.laws[l].force_W : Vec3(-scene.laws[l].force_W);
      const Vec3 arm_W = armOf(scene, rows, l, side);
      const bool turns = side == 0 ? inShaft(scene.plan.laws[l], scene.laws[l]) : isAlongAxis(scene.plan.laws[l].kind);
      turns ? stiffness.addTurning(force_W, arm_W, scene.plan.characteristic_u)
            : stiffness.addFixed(force_W, arm_W, scene.plan.characteristic_u);
    }
  }
}

/// Rows that hold an axis of the body turn with it, too.
bool holdsAxes(const ConstraintScene& scene, const ConstraintRows& rows) noexcept
{
  const auto turns = [&](const ConstraintRow& row)
  {
    const auto& [a, b] = rows.ends[row.law];
    return row.turns && (a.body == scene.plan.held || b.body == scene.plan.held);
  };
  return std::any_of(rows.rows.begin(), rows.rows.begin() + rows.count, turns);
}

bool isStiff(const HeldYield::Square& full, const HeldYield::Square& springs) noexcept
{
  const HeldYield::Square least = full - leastStiff * springs;
  return Eigen::LLT<HeldYield::Square>(least).info() == Eigen::Success;
}

} // namespace

HeldYield yieldOfHeld(const ConstraintScene& scene, const ConstraintRows& rows, const MechanismGrip& grip) noexcept
{
  HeldYield yield;
  if (scene.plan.held < 0)
  {
    return yield;
  }
  const Pose& at = scene.pose_W[scene.plan.held];
  const double k = grip.coupling_N_per_u;
  const Vec3 apart_u = scene.hand_W.p - at.p;
  if (!(grip.turning_Nu_per_rad > 0.0))
  {
    yield.compliance.topLeftCorner<3, 3>().diagonal().setConstant(1.0 / k);
    yield.back_u.head<3>() = apart_u;
    return yield;
  }
  const double characteristic_u = scene.plan.characteristic_u;
  const double turning = grip.turning_Nu_per_rad / (characteristic_u * characteristic_u);
  Stiffness stiffness;
  stiffness.springs.diagonal() << Vec3::Constant(k), Vec3::Constant(turning);
  stiffness.bend.bottomRightCorner<3, 3>() = turning * (bendOfAngle(scene.hand_W.q, at.q) - Mat3::Identity());
  addForces(scene, rows, stiffness);
  HeldYield::Square holds = stiffness.springs + stiffness.bend + stiffness.forces;
  yield.eases = stiffness.forces;
  const bool stiff = isStiff(holds, stiffness.springs);
  yield.exact = stiff && !stiffness.turning && !holdsAxes(scene, rows);
  if (!stiff)
  {
    holds = stiffness.springs;
    holds.diagonal().tail<3>().array() += stiffness.mostOfForces;
  }
  const Eigen::LLT<HeldYield::Square> factor(holds);
  Vec6 pull_N;
  pull_N << k * apart_u, turning * characteristic_u * turnFromTo(at.q, scene.hand_W.q);
  const HeldYield::Square inverse = factor.solve(HeldYield::Square::Identity());
  yield.compliance = 0.5 * (inverse + inverse.transpose());
  yield.back_u = factor.solve(pull_N);
  return yield;
}

} // namespace palpate
