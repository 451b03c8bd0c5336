// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/simulated/ArmPlant.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "haptics/arm/ArmDynamics.h"

namespace palpate
{
namespace
{

using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3>;

/// Matrix from the velocity of the tip to the speeds of the joints; nothing in a singularity.
std::optional<Square> jointsOverTip(const Arm& arm, const Posture& posture) noexcept
{
  const Square J = arm.movedDirections().transpose() * posture.jacobian.topRows<3>();
  const Square inverse = J.inverse();
  return posture.exists && inverse.allFinite() ? std::optional(inverse) : std::nullopt;
}

} // namespace

std::string refuseSimulation(const ArmPlan& plan)
{
  const std::string problem = refuse(plan);
  if (!problem.empty())
  {
    return problem;
  }
  const Arm arm(plan);
  if (arm.joints() != arm.directions() || arm.motors() != arm.directions())
  {
    return "a simulated arm needs a joint with a motor for each direction in which it moves";
  }
  const std::optional<JointVector> middle = arm.inverse(plan.workSpace.centre_D);
  const std::optional<PrincipalPart> part = middle ? principalPartOf(arm, *middle, arm.posture(*middle)) : std::nullopt;
  return !middle                      ? "the arm does not reach the middle of its work space"
         : !part                      ? "the middle of the work space is a singularity"
         : !(part->mass_kg[0] > 1e-6) ? "the arm has no masses: a simulated arm needs inertia at every joint"
                                      : "";
}

std::optional<PrincipalPart> principalPartOf(const Arm& arm, const JointVector& q, const Posture& posture) noexcept
{
  const std::optional<Square> joints = jointsOverTip(arm, posture);
  if (!joints)
  {
    return std::nullopt;
  }
  const int count = arm.directions();
  const Square inertia = joints->transpose() * inertiaOf(arm, q) * *joints;
  const Eigen::SelfAdjointEigenSolver<Square> solver(inertia);
  PrincipalPart part;
  part.count = count;
  part.directions_D.leftCols(count) = arm.movedDirections() * solver.eigenvectors();
  part.mass_kg.head(count) = solver.eigenvalues();
  const Square along = *joints * solver.eigenvectors(); // speeds of the joints in a motion along each direction
  JointVector damping(count);
  for (int k = 0; k < count; ++k)
  {
    const ArmJoint& joint = arm.plan().joints[static_cast<std::size_t>(k)];
    damping[k] = joint.damping_Nms;
    part.friction_N.head(count) += joint.friction_Nm * along.row(k).transpose().cwiseAbs();
  }
  Square across = along.transpose() * damping.asDiagonal() * along;
  part.damping_Ns_per_m.head(count) = across.diagonal();
  across.diagonal().setZero();
  part.dampingAcross.topLeftCorner(count, count) = across;
  return part;
}

ArmPlant::ArmPlant(const ArmPlan& plan, const HandModel& hand, double period_s)
  : arm_(plan), hand_(hand), period_s_(period_s), q_(JointVector::Zero(this->arm_.joints()))
{
}

bool ArmPlant::begin(const Vec3& p_D, const Vec3& v_D) noexcept
{
  const std::optional<JointVector> q = this->arm_.inverse(p_D);
  if (q)
  {
    this->q_ = *q;
    this->p_D_ = p_D;
    this->v_D_ = v_D;
  }
  return q.has_value();
}

Vec3 ArmPlant::shown_D() const noexcept
{
  const std::optional<Pose> shown = this->arm_.forward(this->arm_.shown(this->q_));
  return shown ? shown->p : this->p_D_;
}

/// Force at the tip of motors, gravity, and the Coriolis and centrifugal terms of the motion.
Vec3 ArmPlant::ownForce(const Posture& posture, const Wrench& motors_D) const noexcept
{
  const auto basis = this->arm_.movedDirections();
  const Square joints = *jointsOverTip(this->arm_, posture);
  const JointVector rate = joints * (basis.transpose() * this->v_D_);
  const JointVector motors = motorCommandOf(this->arm_, this->arm_.shown(this->q_), motors_D);
  JointVector torque = this->arm_.ungears().transpose() * motors + gravityTorqueOf(this->arm_, this->q_);
  if (rate.squaredNorm() > 0.0)
  {
    const double h = 1e-5 / rate.norm();
    const ArmJacobian bends =
      (this->arm_.jacobian(this->q_ + h * rate) - this->arm_.jacobian(this->q_ - h * rate)) / (2.0 * h);
    const JointVector turned = joints * (basis.transpose() * (bends.topRows<3>() * rate));
    torque += velocityTorqueOf(this->arm_, this->q_, rate) + inertiaOf(this->arm_, this->q_) * turned;
  }
  return basis * (joints.transpose() * torque);
}

/// Newton's method from the joints before.
std::optional<JointVector> ArmPlant::jointsAt(const Vec3& p_D) const noexcept
{
  constexpr int steps = 6;
  JointVector q = this->q_;
  for (int step = 0; step < steps; ++step)
  {
    const Posture posture = this->arm_.posture(q);
    const std::optional<Square> joints = jointsOverTip(this->arm_, posture);
    if (!joints)
    {
      return std::nullopt;
    }
    q += *joints * (this->arm_.movedDirections().transpose() * (p_D - posture.tip.p));
  }
  const std::optional<Pose> there = this->arm_.forward(q);
  return there && (there->p - p_D).norm() < 1e-12 && this->arm_.withinLimits(q) ? std::optional(q) : std::nullopt;
}

void ArmPlant::step(const Vec3& hand_N, const Wrench& motors_D) noexcept
{
  const Posture posture = this->arm_.posture(this->q_);
  const std::optional<PrincipalPart> part = principalPartOf(this->arm_, this->q_, posture);
  if (!part)
  {
    this->v_D_.setZero();
    return;
  }
  Vec3 p_D = this->p_D_, v_D = this->v_D_;
  PrincipalPlant(*part, this->hand_, this->period_s_).step(p_D, v_D, hand_N + this->ownForce(posture, motors_D));
  const std::optional<JointVector> q = this->jointsAt(p_D);
  if (!q)
  {
    this->v_D_.setZero(); // at the end of a joint
    return;
  }
  this->q_ = *q;
  this->p_D_ = p_D;
  this->v_D_ = v_D;
}

} // namespace palpate
