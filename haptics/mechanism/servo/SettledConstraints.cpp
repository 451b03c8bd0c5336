// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/servo/SettledConstraints.h"

#include <algorithm>

#include "haptics/tool/motion/Turn.h"

namespace palpate
{
namespace
{

/// Of a turn that constraints make in one piece: beyond it their rows would mean little [rad].
constexpr double mostTurn_rad = 0.5;
constexpr int mostParts = 24; ///< in which a tick goes a longer turn, and follows a bent path
/// Of the lever: a mismatch that turns leave between rows and bodies is reduced from there on, and reported as too
/// large.
constexpr double bentFrom = 5e-15, bentMost = 1e-12;
/// Likewise in a tick: so much further a loose body goes at most in a tick that does not meet the constraints.
constexpr double unmetOfLever = 0.01;
/// A step that is not Newton's leaves a share of itself.
constexpr double turnedFrom_rad = 1e-11;

} // namespace

SettledConstraints::SettledConstraints(
  const MechanismInput& input, MechanismState& state, SettledScratch& room) noexcept
  : input_(input), plan_(*input.plan), state_(state),
    room_(room), scene_{ plan_, input.soft, reference_, state.laws, lead_W_ }
{
  if (this->plan_.held >= 0)
  {
    const bool turned = input.grip.turning_Nu_per_rad > 0.0 || !state.placed;
    this->lead_W_ = { input.hand_W.p, turned ? input.hand_W.q.normalized() : state.pose_W[this->plan_.held].q };
  }
  this->begin();
}

void SettledConstraints::begin() noexcept
{
  for (int b = 0; b < this->plan_.bodyCount; ++b)
  {
    const bool led = b == this->plan_.held && !(this->isSprung(b) && this->state_.placed);
    this->reference_[b] = led ? this->lead_W_ : this->state_.pose_W[b];
  }
  this->takeLoose();
}

/// A loose body moves by one step of its inertia in a tick, however often its constraints are solved.
void SettledConstraints::takeLoose() noexcept
{
  for (int b = 0; b < this->plan_.bodyCount; ++b)
  {
    const PlannedBody& body = this->plan_.bodies[b];
    if (isLoose(body))
    {
      this->loose_[b] = yieldOfLoose(
        body, this->reference_[b].q, this->state_.loose[b], this->plan_.characteristic_u, this->input_.dt_s);
      this->scene_.loose = this->loose_;
    }
  }
}

void SettledConstraints::makeRowsFirst() noexcept
{
  makeRows(this->scene_, this->room_.rows);
}

void SettledConstraints::settle() noexcept
{
  this->begin();
  this->solve(ConstraintStart::Bodies);
  for (int left = mostParts; left > 0 && this->mayGoOn(); --left)
  {
    const bool freeStay = this->share_ >= 1.0;
    this->takeForces();
    this->goOn();
    this->solve(freeStay ? ConstraintStart::Before : ConstraintStart::Bodies);
  }
}

/// Free bodies go a part of a turn that is too long for one tick, and else wait for the next.
void SettledConstraints::goOn() noexcept
{
  for (int b = 0; b < this->plan_.bodyCount; ++b)
  {
    const Pose moved = this->movedPose(b);
    const bool goes = this->isSprung(b) || (this->share_ < 1.0 && !isLoose(this->plan_.bodies[b]));
    this->reference_[b].q = goes ? moved.q : this->reference_[b].q;
    this->reference_[b].p = goes && (b != this->plan_.held || this->isSprung(b)) ? moved.p : this->reference_[b].p;
  }
}

/// Turned by the hand's spring: no degree of freedom of its own is left.
bool SettledConstraints::isSprung(int body) const noexcept
{
  return body == this->plan_.held && this->input_.grip.turning_Nu_per_rad > 0.0;
}

double SettledConstraints::shareOf(int body) const noexcept
{
  return this->isSprung(body) ? this->heldShare_ : isLoose(this->plan_.bodies[body]) ? 1.0 : this->share_;
}

bool SettledConstraints::wentInPart() const noexcept
{
  return this->share_ < 1.0 || this->heldShare_ < 1.0;
}

/// While there is work left for as much again.
bool SettledConstraints::mayGoOn() const noexcept
{
  const ConstraintForces& forces = this->room_.forces;
  const bool open = this->wentInPart() || (!forces.capped && !this->isMet());
  return open && this->work_ + forces.work < this->budget_;
}

bool SettledConstraints::isMet() const noexcept
{
  const int held = this->plan_.held;
  const bool newton = held < 0 || !this->isSprung(held) || this->room_.held.exact ||
                      this->motion_[held].tail<3>().norm() < turnedFrom_rad * this->plan_.characteristic_u;
  return newton && this->bent_u() <= bentFrom * this->plan_.characteristic_u;
}

void SettledConstraints::solve(ConstraintStart start) noexcept
{
  ConstraintForces& forces = this->room_.forces;
  ConstraintProblem& problem = this->room_.problem;
  const ConstraintRows& rows = this->room_.rows;
  makeRows(this->scene_, this->room_.rows);
  this->forgetForces();
  this->room_.held = yieldOfHeld(this->scene_, rows, this->input_.grip);
  assembleConstraints(this->scene_, rows, this->input_.grip, this->room_.held, problem);
  forces.force_N.setZero(rows.count);
  for (int i = problem.bounded(); i < rows.count; ++i)
  {
    const ConstraintRow& row = rows.rows[i];
    forces.force_N[i] = row.along_W.dot(this->state_.laws[row.law].force_W);
  }
  const std::uint32_t left = this->budget_ - std::min(this->budget_, this->work_);
  solveConstraints(problem, this->room_.solver, forces, left, start);
  this->work_ += forces.work;
  this->takeMotions();
}

/// A constraint that has no rows any more, broken or open, turns nothing on.
void SettledConstraints::forgetForces() noexcept
{
  for (int l = 0; l < this->plan_.lawCount; ++l)
  {
    Vec3& force_W = this->state_.laws[l].force_W;
    force_W = this->rowsOf(l) > 0 ? force_W : Vec3(Vec3::Zero());
  }
}

/// The next rows, and the effect of forces on turns, begin at these.
void SettledConstraints::takeForces() noexcept
{
  for (int l = 0; l < this->plan_.lawCount; ++l)
  {
    this->state_.laws[l].force_W = this->outcome(l).force_W;
  }
  for (int l = 0; l < this->plan_.lawCount; ++l)
  {
    ConstraintState& law = this->state_.laws[l];
    if (inShaft(this->plan_.laws[l], law) && this->rowsOf(l) > 0)
    {
      law.apart_W = softApart_W(this->scene_, this->room_.rows, l);
      law.seen = true;
    }
  }
}

void SettledConstraints::takeMotions() noexcept
{
  double most_rad = mostTurn_rad, heldMost_rad = mostTurn_rad;
  for (int b = 0; b < this->plan_.bodyCount; ++b)
  {
    this->motion_[b] =
      motionOf(this->scene_, this->room_.rows, this->input_.grip, this->room_.held, this->room_.forces, b);
    if (isLoose(this->plan_.bodies[b]))
    {
      continue;
    }
    double& most = this->isSprung(b) ? heldMost_rad : most_rad;
    most = std::max(most, this->motion_[b].tail<3>().norm() / this->plan_.characteristic_u);
  }
  this->share_ = mostTurn_rad / most_rad;
  this->heldShare_ = mostTurn_rad / heldMost_rad;
}

int SettledConstraints::rowsOf(int law) const noexcept
{
  const auto& rows = this->room_.rows.rows;
  return static_cast<int>(std::count_if(
    rows.begin(), rows.begin() + this->room_.rows.count, [law](const ConstraintRow& r) { return r.law == law; }));
}

ConstraintOutcome SettledConstraints::outcome(int law) const noexcept
{
  return outcomeOf(this->scene_, this->room_.rows, this->room_.forces, law);
}

Vec6 SettledConstraints::pressOnHeld() const noexcept
{
  const bool held = this->plan_.held >= 0;
  return held ? pressOn(this->scene_, this->room_.rows, this->room_.forces, this->plan_.held) : Vec6(Vec6::Zero());
}

/// With the forces and their arms at the end, where the held body has moved and turned from the pose of the rows.
Vec6 SettledConstraints::onHand() const noexcept
{
  const int held = this->plan_.held;
  Vec6 press_N = this->pressOnHeld();
  if (held >= 0)
  {
    const Vec6& motion = this->motion_[held];
    const Vec3 turning_N = press_N.tail<3>();
    press_N -= this->room_.held.eases * motion;
    // The first derivative of a moment is not symmetric: this much it has beside the second one of an energy.
    press_N.tail<3>() += 0.5 / this->plan_.characteristic_u * motion.tail<3>().cross(turning_N);
  }
  return press_N;
}

/// A hand's spring is as long as its force says; free bodies go no further than they turn.
Vec3 SettledConstraints::movedPlace_W(int body) const noexcept
{
  if (body == this->plan_.held)
  {
    return this->lead_W_.p + this->onHand().head<3>() / this->input_.grip.coupling_N_per_u;
  }
  return this->reference_[body].p + this->shareOf(body) * this->motion_[body].head<3>();
}

Pose SettledConstraints::movedPose(int body) const noexcept
{
  const Vec3 turn_rad = this->shareOf(body) / this->plan_.characteristic_u * this->motion_[body].tail<3>();
  Pose moved{ this->movedPlace_W(body), turnBy(turn_rad) * this->reference_[body].q };
  moved.q.normalize();
  return moved;
}

double SettledConstraints::shareOfLoose(int body) const noexcept
{
  const double most_u = this->loose_[body].back_u.norm() + unmetOfLever * this->plan_.characteristic_u;
  return this->capped() ? most_u / std::max(most_u, this->motion_[body].norm()) : 1.0;
}

bool SettledConstraints::capped() const noexcept
{
  return this->room_.forces.capped || this->wentInPart() || this->bent_u() > bentMost * this->plan_.characteristic_u;
}

double SettledConstraints::residual_u() const noexcept
{
  return std::max(this->room_.forces.residual_u, this->left_u()) + this->bent_u();
}

/// By how much rows are not met yet, as bodies have gone a part of their displacement only.
double SettledConstraints::left_u() const noexcept
{
  double most_u = 0.0;
  for (int i = 0; i < this->room_.rows.count && this->wentInPart(); ++i)
  {
    double left_u = 0.0;
    for (int side = 0; side < 2; ++side)
    {
      const ConstraintRow& row = this->room_.rows.rows[i];
      const int body = this->room_.rows.ends[row.law][side].body;
      const Vec6 j = jacobianOf(this->scene_, this->room_.rows, row, side);
      left_u += (1.0 - this->shareOf(body)) * j.dot(this->motion_[body]);
    }
    most_u = std::max(most_u, std::abs(left_u));
  }
  return most_u;
}

/// The largest distance between a constraint's points on the body that the hand's spring turns and their places in the
/// rows.
double SettledConstraints::bent_u() const noexcept
{
  double most_u = 0.0;
  for (int l = 0; l < this->plan_.lawCount; ++l)
  {
    for (int side = 0; side < 2; ++side)
    {
      if (this->isSprung(this->room_.rows.ends[l][side].body) && this->rowsOf(l) > 0)
      {
        most_u = std::max(most_u, this->bentAt_u(armOf(this->scene_, this->room_.rows, l, side).norm()));
      }
    }
  }
  return most_u;
}

/// The remainders of the second order of exp(turn) arm and of a direction that turns while its body goes, and the
/// distance between the hand's spring and its second-order model.
double SettledConstraints::bentAt_u(double arm_u) const noexcept
{
  const int held = this->plan_.held;
  const Vec6& motion = this->motion_[held];
  const double turn_rad = this->heldShare_ * motion.tail<3>().norm() / this->plan_.characteristic_u;
  const double off_u = (this->movedPlace_W(held) - this->reference_[held].p - motion.head<3>()).norm();
  return turn_rad * (0.5 * turn_rad * std::max(arm_u, this->plan_.characteristic_u) + motion.head<3>().norm()) + off_u;
}

double SettledConstraints::stored_Nu() const noexcept
{
  const ConstraintProblem::Numbers& f = this->room_.forces.force_N;
  double stored = 0.5 * f.dot(this->room_.problem.compliance.lazyProduct(f));
  if (this->plan_.held >= 0)
  {
    // The hand's springs with their final length and turn, in place of their part of the rows' compliance.
    const Pose held = this->movedPose(this->plan_.held);
    const Vec6 press_N = this->pressOnHeld();
    const MechanismGrip& grip = this->input_.grip;
    stored += 0.5 * (grip.coupling_N_per_u * (held.p - this->lead_W_.p).squaredNorm() +
                      grip.turning_Nu_per_rad * turnFromTo(this->lead_W_.q, held.q).squaredNorm() -
                      press_N.dot(this->room_.held.compliance * press_N));
  }
  for (int b = 0; b < this->plan_.bodyCount && !this->scene_.loose.empty(); ++b)
  {
    // Inertia stores nothing in its constraints: its part of the rows' compliance is left out.
    const Vec6 press_N = isLoose(this->plan_.bodies[b]) ? pressOn(this->scene_, this->room_.rows, this->room_.forces, b)
                                                        : Vec6(Vec6::Zero());
    stored -= 0.5 * press_N.dot(this->loose_[b].compliance * press_N);
  }
  for (const PressedBody* soft : this->input_.soft)
  {
    stored += soft ? soft->snapshot->energy_Nu : 0.0;
  }
  return std::max(stored, 0.0);
}

} // namespace palpate
