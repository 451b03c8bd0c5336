// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/simulated/labyrinth/BlindHand.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{

/// A handle that is held back this long without coming nearer is at a wall; at least three looks.
constexpr double patience_s = 0.04;
/// The arm slows down near its goal, or friction would make it swing about the goal.
constexpr double approach_Hz = 10.0;
/// A place that is not reached within this multiple of the expected time is unreachable.
constexpr double hopeless = 100.0;
/// Attempts to pass an obstacle before the hand goes back to where this passage began.
constexpr int patientTries = 10;
/// Friction cancels a smaller pull: the arm crosses most of that slack at once, the arm's damper takes the rest.
constexpr double swallowed = 0.75, swallow_s = 0.05;

} // namespace

BlindHand::BlindHand(const BlindPlan& plan, const Vec3& start_D)
  : plan_(plan), start_D_(start_D), arm_D_(start_D), thread_D_{ start_D }
{
  this->choose();
}

Vec3 BlindHand::centre_D(const PlaceMemory::Place& place) const
{
  return this->start_D_ + this->plan_.step_m * Vec3(place.first, place.second, 0);
}

Vec3 BlindHand::goal_D() const
{
  const PlaceMemory::Place& here = this->memory_.here();
  if (this->winds_)
  {
    return this->thread_D_.back();
  }
  return this->centre_D(this->way_ ? PlaceMemory::beside(here, *this->way_) : here);
}

Vec3 BlindHand::look(const Felt& felt, double dt_s)
{
  if (!this->exhausted_ && !this->lost_)
  {
    this->decide(felt, dt_s);
    this->lead(felt, dt_s);
  }
  return this->arm_D_;
}

void BlindHand::decide(const Felt& felt, double dt_s)
{
  this->since_s_ += dt_s;
  this->follow(felt);
  if (this->reached(felt))
  {
    if (this->way_)
    {
      this->memory_.walked(*this->way_);
    }
    this->thread_D_.assign(1, felt.location_D);
    this->choose();
  }
  else if (this->stopped(felt, dt_s))
  {
    if (this->known())
    {
      this->feelAbout(felt);
    }
    else
    {
      this->memory_.closed(*this->way_);
      this->set(std::nullopt);
    }
  }
  else if (this->since_s_ > hopeless * (this->plan_.step_m + this->plan_.lead_m) / this->plan_.speed_m_per_s)
  {
    this->lost_ = true;
  }
}

/// Ariadne's thread: laid out on the outward path, wound up on the return.
void BlindHand::follow(const Felt& felt)
{
  const auto near = [&](const Vec3& p_D) { return (felt.location_D - p_D).norm() <= this->plan_.near_m; };
  if (!this->winds_ && !near(this->thread_D_.back()))
  {
    this->thread_D_.push_back(felt.location_D);
  }
  while (this->winds_ && near(this->thread_D_.back()))
  {
    this->winds_ = this->thread_D_.size() > 1;
    this->thread_D_.resize(std::max<std::size_t>(1, this->thread_D_.size() - 1));
    this->startAnew();
  }
}

bool BlindHand::known() const
{
  return !this->way_ || this->memory_.knows(PlaceMemory::beside(this->memory_.here(), *this->way_));
}

bool BlindHand::reached(const Felt& felt) const
{
  return !this->winds_ &&
         (felt.location_D - this->goal_D()).norm() <= (this->known() ? this->plan_.again_m : this->plan_.near_m);
}

/// A passage that was open is open: the end of a wall is in between, so the hand passes a little to the left, or to the
/// right; a hand that came round an end goes back along the thread.
void BlindHand::feelAbout(const Felt& felt)
{
  ++this->tries_;
  this->startAnew();
  if (!this->winds_ && this->thread_D_.size() > 1 && (!this->way_ || this->tries_ % patientTries == 0))
  {
    this->winds_ = true;
    return;
  }
  const Vec3 ahead = (this->goal_D() - felt.location_D).normalized(), left(-ahead.y(), ahead.x(), 0);
  const double side = this->tries_ % 2 == 1 ? 1.0 : -1.0, share = 0.1 * ((this->tries_ + 1) / 2 % 5);
  this->aside_D_ = side * share * this->plan_.step_m * left;
}

/// True if the handle comes no nearer while the hand is pushed back or has arrived, or comes no nearer for so long that
/// the arm could have reached its largest push.
bool BlindHand::stopped(const Felt& felt, double dt_s)
{
  const Vec3 ahead = this->goal_D() - felt.location_D;
  const double left_m = ahead.norm();
  if (left_m < this->least_m_ - 0.02 * this->plan_.step_m)
  {
    this->least_m_ = left_m;
    this->held_s_ = this->idle_s_ = 0.0;
  }
  const bool pushedBack = -felt.force_D.dot(ahead) > this->plan_.touch_N * left_m;
  const bool there = (felt.handle_D - this->goal_D() - this->aside_D_).cwiseAbs().maxCoeff() <= this->plan_.grain_m;
  this->held_s_ += pushedBack || there ? dt_s : 0.0;
  this->idle_s_ += dt_s;
  const double swing_s = 2 * this->plan_.lead_m / this->plan_.speed_m_per_s;
  return std::max(this->held_s_, this->idle_s_ - swing_s) >= std::max(patience_s, 3 * dt_s);
}

void BlindHand::choose()
{
  this->set(this->memory_.next());
  this->exhausted_ = !this->way_;
}

void BlindHand::set(std::optional<int> way)
{
  this->way_ = way;
  this->winds_ = false;
  this->tries_ = 0;
  this->since_s_ = 0.0;
  this->startAnew();
}

void BlindHand::startAnew()
{
  this->aside_D_ = Vec3::Zero();
  this->held_s_ = this->idle_s_ = 0.0;
  this->least_m_ = std::numeric_limits<double>::infinity();
}

/// Distance by which the arm may move at once without moving the handle, for friction holds the handle.
double BlindHand::unfelt_m(double ahead_m, double dt_s) const
{
  const double slack_m = swallowed * this->plan_.friction_m - ahead_m;
  return std::clamp(slack_m, 0.0, this->plan_.friction_m / swallow_s * dt_s);
}

/// Each axis by itself, as friction acts on each axis by itself: the arm goes on until the handle has arrived.
void BlindHand::lead(const Felt& felt, double dt_s)
{
  const Vec3 missing = this->goal_D() + this->aside_D_ - felt.handle_D;
  for (int axis = 0; axis < 2; ++axis)
  {
    if (std::fabs(missing[axis]) > this->plan_.grain_m)
    {
      const double most_m = this->plan_.speed_m_per_s * dt_s, wish_m = approach_Hz * dt_s * missing[axis];
      const double way = std::copysign(1.0, missing[axis]);
      const double unfelt_m = this->unfelt_m(way * (this->arm_D_[axis] - felt.handle_D[axis]), dt_s);
      this->arm_D_[axis] += way * unfelt_m + std::clamp(wish_m, -most_m, most_m);
    }
    const double from_m = felt.handle_D[axis];
    this->arm_D_[axis] = std::clamp(this->arm_D_[axis], from_m - this->plan_.lead_m, from_m + this->plan_.lead_m);
  }
}

} // namespace palpate
