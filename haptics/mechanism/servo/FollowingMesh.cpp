// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/servo/FollowingMesh.h"

#include <algorithm>

#include "haptics/core/Fade.h"
#include "haptics/core/PoseMath.h"
#include "haptics/mechanism/servo/HandLead.h"
#include "haptics/mechanism/servo/StandingGuard.h"
#include "haptics/tool/motion/Turn.h"

namespace palpate
{
namespace
{

/// A mesh that is behind by less than this many newtons of the hand's spring is led by the hand again.
constexpr double leastCatchUp_N = 0.02;
constexpr Fade lagFade{ ToolBlend::fade_s };
/// Of the reach of an answer.
constexpr double roundingOfReach = 1e-9;
/// A spring that holds a turn is wound by less than this share of it.
constexpr double roundingOfTurn = 0.1;

} // namespace

FollowingMesh::FollowingMesh(MechanismInput& input, int named, MechanismState& state, SettledConstraints& laws) noexcept
  : input_(input), plan_(*input.plan), named_(named), state_(state), laws_(laws), hand_W_(laws.lead_W()),
    turning_Nu_per_rad_(input.grip.turning_Nu_per_rad), turns_(turning_Nu_per_rad_ > 0.0)
{
}

bool FollowingMesh::isAtRest() const noexcept
{
  const auto rests = [](const PressedBody* soft) { return soft && soft->period_s <= 0.0; };
  return std::ranges::any_of(this->input_.soft, rests);
}

bool FollowingMesh::isBehind() const noexcept
{
  return this->turnIsHeld_ || HandLead{ this->hand_W_, this->laws_.lead_W() }.isBehind();
}

bool FollowingMesh::isOther() const noexcept
{
  const FoundContacts* const newest = this->input_.found;
  if (newest == nullptr || newest->answer == this->state_.found.answer)
  {
    return false;
  }
  return !this->state_.placed || this->state_.found.answer == 0 ||
         this->takenOf(*newest) <= std::max(1.0, this->takenOf(this->state_.found));
}

double FollowingMesh::takenOf(const FoundContacts& found) const noexcept
{
  return this->plan_.held < 0
           ? 0.0
           : reachTaken(found, this->plan_.bodies[this->plan_.held], this->state_.pose_W[this->plan_.held]);
}

bool FollowingMesh::isPressed() const noexcept
{
  const bool pushed = this->isGuarded() && this->state_.push_N != Vec3::Zero(); // contacts of one tick
  return pushed || std::any_of(this->state_.laws.begin(), this->state_.laws.begin() + this->plan_.lawCount,
                     [](const ConstraintState& law) { return law.force_W != Vec3::Zero(); });
}

double FollowingMesh::quickShare() const noexcept
{
  return this->isAtRest() ? 1.0
                          : std::max(1.0 - lagFade.explicitShare(this->input_.dt_s), this->shareOf(leastCatchUp_N));
}

double FollowingMesh::gentleShare() const noexcept
{
  return this->quickShare() < 1.0 ? std::min(this->quickShare(), this->shareOf(ToolBlend::largestStep_N)) : 1.0;
}

double FollowingMesh::shareOf(double force_N) const noexcept
{
  const double way_u = behind_u(this->state_.led, this->plan_.characteristic_u);
  return std::min(1.0, force_N / std::max(this->input_.grip.coupling_N_per_u * way_u, force_N));
}

void FollowingMesh::follow(bool touches) noexcept
{
  const double share = touches ? this->gentleShare() : this->quickShare();
  const Pose lead_W = followed(this->state_.led, this->hand_W_, share);
  this->laws_.lead({ lead_W.p, this->turns_ ? lead_W.q : this->hand_W_.q });
}

void FollowingMesh::slowDown() noexcept
{
  if (this->plan_.held < 0)
  {
    return;
  }
  constexpr int mostTries = 4;
  const double before = this->state_.placed ? this->takenOf(this->state_.found) : 0.0;
  const double most = std::max(before, 1.0);
  const Pose to_W = this->laws_.lead_W();
  const Pose from_W = this->state_.placed ? this->state_.led.lead_W : this->state_.found.held_W;
  double share = 1.0;
  for (int tries = 0; this->taken() > most * (1.0 + roundingOfReach) && share > 0.0; ++tries)
  {
    share = tries < mostTries ? share * (most - before) / (this->taken() - before) : 0.0; // convex: no chord is longer
    const Pose lead_W = partOfWay(from_W, to_W, share);
    this->laws_.lead({ lead_W.p, this->turns_ ? lead_W.q : to_W.q });
    this->laws_.settle();
  }
  if ((!this->turns_ || this->isGuarded()) && this->taken() > most * (1.0 + roundingOfReach))
  {
    this->holdTurn(this->state_.placed ? this->state_.pose_W[this->plan_.held].q : this->laws_.lead_W().q);
    this->turnIsSlowed_ = false;
  }
}

void FollowingMesh::slowTurn() noexcept
{
  if (this->plan_.held < 0 || !this->state_.placed || !this->isGuarded() || this->isAtRest())
  {
    return;
  }
  const Quat& from_W = this->state_.pose_W[this->plan_.held].q;
  const Quat to_W = this->laws_.movedPose(this->plan_.held).q;
  const double turn_rad = turnFromTo(from_W, to_W).norm(), most_rad = this->mostTurn_rad();
  if (turn_rad > most_rad * (1.0 + roundingOfTurn))
  {
    const Pose origin{ Vec3::Zero(), from_W }, end{ Vec3::Zero(), to_W };
    this->holdTurn(partOfWay(origin, end, most_rad / turn_rad).q);
    this->turnIsSlowed_ = true;
  }
}

Pose FollowingMesh::led_W() const noexcept
{
  const Pose& lead_W = this->laws_.lead_W();
  return { lead_W.p, this->turnIsSlowed_ ? this->lead_W_.q : lead_W.q };
}

double FollowingMesh::taken() const noexcept
{
  const int held = this->plan_.held;
  return reachTaken(this->state_.found, this->plan_.bodies[held], this->laws_.movedPose(held));
}

void FollowingMesh::holdTurn(const Quat& at_W) noexcept
{
  constexpr double stiffer = 100.0; // than the hand's spring at the mesh's size
  const double arm_u = this->plan_.characteristic_u;
  this->lead_W_ = this->turnIsHeld_ ? this->lead_W_ : this->laws_.lead_W();
  this->turnIsHeld_ = true;
  this->input_.grip.turning_Nu_per_rad =
    std::max(stiffer * this->input_.grip.coupling_N_per_u * arm_u * arm_u, this->turning_Nu_per_rad_);
  this->laws_.lead({ this->laws_.lead_W().p, at_W });
  this->laws_.settle();
}

double FollowingMesh::shareOfTick(const ScrewStep& way, bool freely) const noexcept
{
  const Pose& lead_W = this->laws_.lead_W();
  const auto shareOf = [](double most, double length) { return most / std::max(most, length); };
  if (this->isAtRest())
  {
    const double most_u = 2.0 * (way.from_W.p - lead_W.p).norm() + this->plan_.characteristic_u;
    return shareOf(most_u, way.v_W.norm());
  }
  if (freely && !this->laws_.capped())
  {
    return 1.0;
  }
  const double ofHand_u = (lead_W.p - this->state_.led.lead_W.p).norm();
  const double most_u = ofHand_u + ToolBlend::largestStep_N / this->input_.grip.coupling_N_per_u;
  return std::min(shareOf(most_u, way.v_W.norm()), shareOf(this->mostTurn_rad(), way.w_W.norm()));
}

bool FollowingMesh::isBesideLoose() const noexcept
{
  const auto last = this->plan_.bodies.begin() + this->plan_.bodyCount;
  return std::any_of(this->plan_.bodies.begin(), last, [](const PlannedBody& body) { return isLoose(body); });
}

double FollowingMesh::mostTurn_rad() const noexcept
{
  const Quat& lead_W = this->turnIsHeld_ ? this->lead_W_.q : this->laws_.lead_W().q;
  const double ofHand_rad = this->turns_ ? turnFromTo(this->state_.led.lead_W.q, lead_W).norm() : 0.0;
  return std::max(StandingGuard::mostTurn_rad, ofHand_rad);
}

Vec6 FollowingMesh::felt(Vec6 hand_N) const noexcept
{
  if (this->turnIsHeld_ && this->isGuarded())
  {
    const Quat& held_W = this->state_.pose_W[this->plan_.held].q;
    hand_N.tail<3>() = this->turning_Nu_per_rad_ / this->plan_.characteristic_u * turnFromTo(this->lead_W_.q, held_W);
  }
  return hand_N;
}

Vec6 FollowingMesh::stopBefore(const Pose& before_W) noexcept
{
  Pose& held_W = this->state_.pose_W[this->plan_.held];
  const Pose to_W = held_W;
  double share = 1.0;
  for (int tries = 0; tries < 8 && share > 0.0; ++tries)
  {
    const double less = this->shareBefore(before_W, held_W);
    if (less >= 1.0)
    {
      break;
    }
    share = tries < 7 ? share * less : 0.0;
    held_W = partOfWay(before_W, to_W, share);
  }
  return share < 1.0 ? this->stopAt(held_W) : this->laws_.onHand();
}

Vec6 FollowingMesh::stopAt(const Pose& at_W) noexcept
{
  const Pose& lead_W = this->laws_.lead_W();
  const MechanismGrip& grip = this->input_.grip;
  const Vec3 turn_rad = this->turns_ ? turnFromTo(lead_W.q, at_W.q) : Vec3(Vec3::Zero());
  this->state_.pose_W[this->plan_.held] = at_W;
  Vec6 hand_N;
  hand_N << grip.coupling_N_per_u * (at_W.p - lead_W.p),
    grip.turning_Nu_per_rad / this->plan_.characteristic_u * turn_rad;
  return hand_N;
}

double FollowingMesh::shareBefore(const Pose& from_W, const Pose& to_W) const noexcept
{
  const double rounding_u = roundingOfReach * this->plan_.characteristic_u;
  double share = 1.0;
  for (int l = this->named_; l < this->plan_.lawCount; ++l)
  {
    const PlannedConstraint& law = this->plan_.laws[l];
    const auto gap_u = [&law](const Pose& at_W) { return law.axis_B.dot(at_W * law.point_A - law.point_B); };
    if (law.a != this->plan_.held || this->plan_.bodies[law.b].kind != MechanismBodyKind::World)
    {
      continue;
    }
    const double from_u = gap_u(from_W), to_u = gap_u(to_W), least_u = std::min(from_u, 0.0);
    share = to_u < least_u - rounding_u ? std::min(share, (from_u - least_u) / (from_u - to_u)) : share;
  }
  return share;
}

} // namespace palpate
