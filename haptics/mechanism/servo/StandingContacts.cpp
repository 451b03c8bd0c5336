// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/servo/StandingContacts.h"

#include <algorithm>
#include <utility>

#include "haptics/core/PoseMath.h"
#include "haptics/mechanism/sided/StandingBody.h"

namespace palpate
{
namespace
{

constexpr std::uint64_t workOfLook = 5000, workOfTick = 10000;
/// With so much work done the constraints of a tick are not solved once more.
constexpr std::uint32_t mostOfSolver = 4 * lawWorkBudget / 3;
/// A guard's unit of work is one and a half of a constraint's.
constexpr std::uint64_t halvesOfUnit = 3;
constexpr int mostRounds = 8;
/// A motion for which there is not enough work is shortened by that factor each time, down to the least part.
constexpr double shorter = 0.25, leastPart = 1.0 / 64.0;
/// Constraints that are left by no more than that share of the rest distance are met, whatever work that took.
constexpr double negligible = 1e-3;
/// A contact that still comes too near is lifted by more each time, in rest distances.
constexpr double firstLift = 0.5, mostLift = 8.0;

} // namespace

StandingContacts::StandingContacts(const MechanismInput& input, int named, MechanismPlan& joined, MechanismState& state,
  SettledConstraints& laws, FollowingMesh& mesh) noexcept
  : plan_(*input.plan), named_(named), joined_(joined), state_(state), laws_(laws), mesh_(mesh), guard_(input.meshes),
    lift_u_(firstLift * guard_.rest_u()), freely_(mesh.isBesideLoose())
{
}

void StandingContacts::goFree() noexcept
{
  if (!this->guard_.guards() || !this->state_.placed)
  {
    return;
  }
  if (this->state_.capped)
  {
    this->settleSmooth();
  }
  for (int round = 0;;)
  {
    const Way way = this->wayOfTick();
    const FreeWay free = this->look(way.step);
    if (free.spent && std::exchange(this->freely_, false))
    {
      continue;
    }
    if (free.spent && this->part_ > leastPart && this->work_ < workOfTick)
    {
      this->part_ *= shorter;
      continue;
    }
    if (free.spent) // at the first look, the contacts that were found hold the mesh alone
    {
      if (round == 0)
      {
        this->stayNear();
      }
      return; // later on, the mesh goes as far as was proven before
    }
    this->stopsAt_ = free.share * way.share < 1.0 ? std::optional(way.step.end_W(free.share)) : std::nullopt;
    const bool last = round == mostRounds || this->laws_.work() > mostOfSolver;
    if (last || free.count == 0 || !this->press(free, way.step))
    {
      return;
    }
    ++round;
    this->settle();
  }
}

/// Beside loose bodies constraints may bring the mesh anywhere in a tick, as nothing else is behind the body that it
/// pushes: unproven, the mesh goes no further than others do, and stays where the constraints are not met.
void StandingContacts::stayNear() noexcept
{
  if (this->mesh_.isBesideLoose())
  {
    this->part_ = 1.0;
    this->stopsAt_ = this->wayOfTick().step.end_W(this->laws_.capped() ? 0.0 : 1.0);
  }
}

StandingContacts::Way StandingContacts::wayOfTick() const noexcept
{
  const int held = this->plan_.held;
  Way way{ wayOf(this->state_.pose_W[held], this->laws_.movedPose(held)), this->part_ };
  way.share *= this->mesh_.shareOfTick(way.step, this->freely_);
  way.step.v_W *= way.share;
  way.step.w_W *= way.share;
  return way;
}

FreeWay StandingContacts::look(const ScrewStep& way) noexcept
{
  const std::uint64_t most = this->freely_ ? workOfLook / 2 : workOfLook;
  const std::uint64_t granted = std::min(most, workOfTick - std::min(workOfTick, this->work_));
  WorkBudget budget(granted);
  const FreeWay free = this->guard_.look(way, budget);
  this->work_ += granted - budget.left();
  return free;
}

std::uint32_t StandingContacts::work() const noexcept
{
  return static_cast<std::uint32_t>(halvesOfUnit * this->work_ / 2);
}

void StandingContacts::settle() noexcept
{
  this->laws_.allowMore();
  this->laws_.settle();
  this->mesh_.slowTurn();
}

/// Friction that cannot be solved would hold the mesh for good: after a tick that has not met the constraints, one
/// that does not meet them either is solved without.
void StandingContacts::settleSmooth() noexcept
{
  if (!this->laws_.capped() || this->laws_.residual_u() <= negligible * this->guard_.rest_u())
  {
    return;
  }
  for (int l = this->named_; l < this->plan_.lawCount; ++l)
  {
    PlannedConstraint& law = this->joined_.laws[l];
    law.kind = this->isOfBoth(law) && law.kind == ConstraintKind::Friction ? ConstraintKind::Contact : law.kind;
  }
  this->smooth_ = true;
  this->settle();
}

bool StandingContacts::isOfBoth(const PlannedConstraint& law) const noexcept
{
  return law.a == this->plan_.held && this->plan_.bodies[law.b].kind == MechanismBodyKind::World;
}

/// False where nothing more can be done in this tick.
bool StandingContacts::press(const FreeWay& free, const ScrewStep& way) noexcept
{
  bool any = false;
  for (int i = 0; i < free.count; ++i)
  {
    const bool pressed = this->raise(free.met[i], way) || this->add(free.met[i], way);
    any = any || pressed;
  }
  return any;
}

/// A contact that is there already and still comes too near, as the mesh turns about it, is kept a little further off.
bool StandingContacts::raise(const MetPlace& met, const ScrewStep& way) noexcept
{
  const Vec3 point_A = into(way.end_W(met.seen), met.at.onTool_W);
  const int body = this->bodyOf(met.mesh);
  for (int l = this->named_; l < this->plan_.lawCount; ++l)
  {
    PlannedConstraint& law = this->joined_.laws[l];
    if (this->isOfBoth(law) && law.b == body && law.axis_B.dot(met.at.n) > StandingGuard::sameNormal &&
        (law.point_A - point_A).norm() < this->guard_.samePlace_u())
    {
      const double lacks_u = law.axis_B.dot(met.at.onScene_W - law.point_B) + 2.0 * this->guard_.rest_u();
      law.point_B += std::max(lacks_u, this->lift_u_) * law.axis_B;
      this->lift_u_ = std::min(2.0 * this->lift_u_, mostLift * this->guard_.rest_u());
      return true;
    }
  }
  return false;
}

bool StandingContacts::add(const MetPlace& met, const ScrewStep& way) noexcept
{
  const int l = this->count_ < most ? this->room() : -1;
  if (l < 0)
  {
    return false;
  }
  FoundContact contact;
  contact.mesh = this->plan_.held;
  contact.body = this->bodyOf(met.mesh);
  contact.point_A = into(way.end_W(met.seen), met.at.onTool_W);
  contact.place_B.x_W = met.at.onScene_W;
  contact.normal_B = met.at.n;
  contact.friction = this->smooth_ ? 0.0 : std::max(this->guard_.friction(met.mesh), 0.0);
  FoundContact& shown = this->state_.found.contacts[l - this->named_]; // for readers
  this->instead_[this->count_++] = { l, this->state_.laws[l], shown };
  shown = contact;
  PlannedConstraint& law = this->joined_.laws[l];
  law = {};
  law.kind = contact.friction > 0.0 ? ConstraintKind::Friction : ConstraintKind::Contact;
  law.friction = contact.friction;
  law.a = contact.mesh;
  law.b = contact.body;
  law.point_A = contact.point_A;
  law.point_B = contact.place_B.x_W + this->rest_u() * contact.normal_B;
  law.axis_B = contact.normal_B;
  this->state_.laws[l] = {};
  this->state_.laws[l].placed = true;
  this->state_.laws[l].stuck_u = way.from_W * law.point_A - law.point_B; // it slips from where this tick begins
  return true;
}

/// A further constraint, or that of a found contact with a mesh that stands which does not press and is the furthest:
/// it is not needed in this tick. -1: there is none.
int StandingContacts::room() noexcept
{
  if (this->plan_.lawCount < static_cast<int>(this->joined_.laws.size()))
  {
    return this->joined_.lawCount++;
  }
  int best = -1;
  double most_u = 0.0;
  const Pose& at_W = this->state_.pose_W[this->plan_.held];
  for (int l = this->named_; l < this->plan_.lawCount; ++l)
  {
    const PlannedConstraint& law = this->plan_.laws[l];
    const double gap_u = law.axis_B.dot(at_W * law.point_A - law.point_B);
    if (!this->isOwn(l) && this->isOfBoth(law) && gap_u > most_u && this->laws_.outcome(l).push_N <= 0.0)
    {
      best = l;
      most_u = gap_u;
    }
  }
  return best;
}

bool StandingContacts::isOwn(int law) const noexcept
{
  const auto last = this->instead_.begin() + this->count_;
  return std::any_of(this->instead_.begin(), last, [law](const Instead& own) { return own.law == law; });
}

int StandingContacts::bodyOf(int mesh) const noexcept
{
  int body = 0;
  for (int left = mesh + 1; body < this->plan_.bodyCount; ++body)
  {
    left -= isStandingMesh(this->plan_.bodies[body]) ? 1 : 0;
    if (left == 0)
    {
      break;
    }
  }
  return body;
}

void StandingContacts::forget() noexcept
{
  for (int i = this->count_ - 1; i >= 0; --i)
  {
    const Instead& was = this->instead_[i];
    this->state_.laws[was.law] = was.state;
    this->state_.found.contacts[was.law - this->named_] = was.contact;
  }
}

} // namespace palpate
