// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/servo/MechanismTick.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "haptics/core/PoseMath.h"
#include "haptics/mechanism/SoundPose.h"
#include "haptics/mechanism/servo/FollowingMesh.h"
#include "haptics/mechanism/servo/HandLead.h"
#include "haptics/mechanism/servo/JoinedFound.h"
#include "haptics/mechanism/servo/SettledConstraints.h"
#include "haptics/mechanism/servo/SoftReturn.h"
#include "haptics/mechanism/servo/StandingContacts.h"
#include "haptics/mechanism/servo/TipPlace.h"
#include "haptics/mechanism/servo/WireInHand.h"

namespace palpate
{

/// Workspace of a tick.
struct MechanismScratch
{
  MechanismPlan joined; ///< with the contacts that were found
  SettledScratch laws;
  MechanismResult result;
  WireTick wire;
};

namespace
{

/// Of the lever in a second: so fast loose bodies leave one another.
constexpr double apartOfLever_per_s = 0.02;

/// One tick.
class MechanismStep
{
public:
  /// `input.plan`: the joined one, which another answer of the finder changes; `named`: its own constraints.
  MechanismStep(
    const MechanismInput& input, const MechanismPlan& named, MechanismState& state, MechanismScratch& room) noexcept
    : input_(input), named_(named), plan_(*input.plan), joined_(room.joined), state_(state), result_(room.result),
      laws_(input_, state, room.laws), mesh_(input_, named.lawCount, state, laws_),
      standing_(input_, named.lawCount, room.joined, state, laws_, mesh_)
  {
  }

  void run() noexcept
  {
    this->result_ = {};
    const bool first = !this->state_.placed; // constraints that hold then make no step in the force
    const bool pressed = this->mesh_.isPressed();
    if (!first)
    {
      this->mesh_.follow(pressed);
    }
    this->tip_W_ = this->plan_.held >= 0 ? this->tipOf(this->laws_.lead_W()) : Vec3(Vec3::Zero());
    this->takeSnapshots();
    this->meetSurfaces();
    this->leadApart();
    (void)(first && this->tryWaiting());
    const bool others = this->mesh_.isOther();
    Vec6 before_N = this->pushBefore();
    if (others)
    {
      this->takeFound();
    }
    this->laws_.settle();
    if (!first && !pressed && this->state_.led.isBehind() && this->laws_.onHand() != Vec6::Zero())
    {
      this->mesh_.follow(true);
      this->laws_.settle();
    }
    this->mesh_.slowTurn();
    this->mesh_.slowDown();
    const bool unmet = this->state_.capped || this->laws_.capped();
    before_N = others || unmet ? before_N : this->laws_.onHand();
    std::size_t changes = 0;
    for (bool more = !first && this->tryWaiting();
         changes < Mechanism::mostConstraints && (more || this->changeConstraints()); more = false)
    {
      this->laws_.settle();
      ++changes;
    }
    this->standing_.goFree();
    this->keep();
    this->standing_.forget();
    this->tellHand(before_N, (changes > 0 || others || unmet) && !first);
  }

private:
  [[nodiscard]] Vec3 tipOf(const Pose& held) const noexcept
  {
    return held.p + this->plan_.bodies[this->plan_.held].length_u * (held.q * Vec3::UnitZ());
  }

  [[nodiscard]] const PressedBody* softOf(int body) const noexcept
  {
    const int soft = this->plan_.bodies[body].soft;
    return soft >= 0 ? this->input_.soft[soft] : nullptr;
  }

  /// The answer before ends here: the step that this makes in the force is spread as others are.
  void takeFound() noexcept
  {
    PosesOfBodies pose_W = this->state_.pose_W;
    if (this->plan_.held >= 0 && !this->state_.placed)
    {
      pose_W[this->plan_.held] = this->laws_.lead_W();
    }
    palpate::takeFound(*this->input_.found, this->named_.lawCount, pose_W, this->state_);
    joinFound(this->named_, this->state_.found, pose_W, this->joined_, this->standing_.rest_u());
    this->leadApart();
  }

  /// Loose bodies that are in others, as they turn or begin, go apart slowly: in one tick that would throw them.
  void leadApart() noexcept
  {
    const double most_u = apartOfLever_per_s * this->plan_.characteristic_u * this->input_.dt_s;
    for (int l = 0; l < this->plan_.lawCount; ++l)
    {
      const PlannedConstraint& law = this->plan_.laws[l];
      const bool loose = isLoose(this->plan_.bodies[law.a]) || isLoose(this->plan_.bodies[law.b]);
      const bool pushes = law.kind == ConstraintKind::Contact || law.kind == ConstraintKind::Friction;
      if (loose && pushes && !this->softOf(law.a) && !this->softOf(law.b))
      {
        const Pose& b = this->poseBefore(law.b);
        const Vec3 normal_W = b.q * law.axis_B;
        const double deep_u = -normal_W.dot(this->poseBefore(law.a) * law.point_A - b * law.point_B);
        this->state_.laws[l].offset_W = std::max(deep_u - most_u, 0.0) * normal_W;
      }
    }
  }

  [[nodiscard]] const Pose& poseBefore(int body) const noexcept
  {
    const bool led = body == this->plan_.held && !this->state_.placed;
    return led ? this->laws_.lead_W() : this->state_.pose_W[body];
  }

  /// The force on the hand in the tick before. From there another answer makes a step, and a tick that does not meet
  /// the constraints, as it may miss them by much.
  [[nodiscard]] Vec6 pushBefore() const noexcept
  {
    Vec6 push_N;
    push_N << this->state_.push_N, this->state_.turning_N;
    return push_N;
  }

  /// Under the same forces a later snapshot would have points elsewhere: that much offset keeps them, and fades.
  void takeSnapshots() noexcept
  {
    this->laws_.makeRowsFirst();
    for (int l = 0; l < this->plan_.lawCount; ++l)
    {
      ConstraintState& law = this->state_.laws[l];
      bool anew = false;
      double left = 1.0;
      for (const int body : { this->plan_.laws[l].a, this->plan_.laws[l].b })
      {
        const PressedBody* soft = this->softOf(body);
        anew = anew || (soft && soft->revision != this->state_.snapshot[this->plan_.bodies[body].soft]);
        left = soft && soft->period_s <= 0.0 ? 0.0 : left;
      }
      if (anew && law.seen)
      {
        law.offset_W += law.apart_W - softApart_W(this->laws_.scene(), this->laws_.rows(), l);
      }
      law.offset_W *= std::min(left, snapshotFade.explicitShare(this->input_.dt_s));
    }
    for (std::size_t s = 0; s < this->input_.soft.size(); ++s)
    {
      this->state_.snapshot[s] = this->input_.soft[s] ? this->input_.soft[s]->revision : 0;
    }
  }

  /// From where constraints held the tip to where the hand leads it: others may keep it from a surface that it is led
  /// through.
  void meetSurfaces() noexcept
  {
    for (int l = 0; l < this->plan_.lawCount && this->state_.placed; ++l)
    {
      const PlannedConstraint& law = this->plan_.laws[l];
      ConstraintState& state = this->state_.laws[l];
      const PressedBody* soft = this->softOf(law.b);
      if (law.kind == ConstraintKind::Puncture && state.phase == ConstraintPhase::Open && !state.met && soft)
      {
        state.met = meetSurface(*soft, this->state_.tip_W, this->tip_W_, state);
      }
    }
  }

  /// Constraints that wait are tried in each tick: those that would break at once go on waiting.
  [[nodiscard]] bool tryWaiting() noexcept
  {
    bool any = false;
    for (int l = 0; l < this->plan_.lawCount; ++l)
    {
      this->tried_[l] = std::exchange(this->state_.laws[l].waits, false);
      any = any || this->tried_[l];
    }
    return any;
  }

  /// True if a constraint has changed: then all are solved anew.
  [[nodiscard]] bool changeConstraints() noexcept
  {
    bool changed = false;
    for (int l = 0; l < this->plan_.lawCount; ++l)
    {
      const ConstraintOutcome outcome = this->laws_.outcome(l);
      if (this->tried_[l] && givesWay(this->plan_.laws[l], outcome))
      {
        this->state_.laws[l].waits = changed = true;
        this->tried_[l] = false;
        continue;
      }
      const auto change = changeConstraint(this->plan_.laws[l], outcome, this->state_.laws[l]);
      if (change && this->result_.eventCount < static_cast<int>(this->result_.events.size()))
      {
        this->result_.events[this->result_.eventCount++] = { this->input_.tick, *change, static_cast<std::uint32_t>(l),
          outcome.force_W.norm() };
      }
      changed = changed || change;
    }
    return changed;
  }

  /// Keeps the outcome of the constraints for the next tick and for readers.
  void keep() noexcept
  {
    const PosesOfBodies before_W = this->state_.pose_W;
    for (int b = 0; b < this->plan_.bodyCount; ++b)
    {
      this->keepBody(b);
    }
    const bool stops = this->laws_.capped() && this->state_.placed && this->plan_.held >= 0;
    this->hand_N_ = stops ? this->mesh_.stopBefore(before_W[this->plan_.held]) : this->laws_.onHand();
    this->hand_N_ =
      this->mesh_.felt(this->standing_.stopsAt() ? this->mesh_.stopAt(*this->standing_.stopsAt()) : this->hand_N_);
    for (int l = 0; l < this->plan_.lawCount; ++l)
    {
      this->keepConstraint(l);
    }
    for (int l = 0; l < this->plan_.lawCount; ++l)
    {
      if (this->laws_.rowsOf(l) > 0)
      {
        this->state_.laws[l].apart_W = softApart_W(this->laws_.scene(), this->laws_.rows(), l);
        const auto& [a, b] = this->laws_.rows().ends[l];
        Vec3& at_W = this->result_.laws[l].at_W; // of two soft bodies, by the forces of all constraints
        at_W = a.soft >= 0 && b.soft >= 0 ? yielded_W(this->laws_.scene(), this->laws_.rows(), l, 1) : at_W;
        this->slide(l);
        this->tellPresses(l);
      }
    }
    returnNoMore(this->plan_, this->laws_, before_W, this->input_.dt_s, this->state_);
    this->state_.tip_W =
      this->plan_.held >= 0 ? this->tipOf(this->state_.pose_W[this->plan_.held]) : Vec3(Vec3::Zero());
    this->state_.led = { this->mesh_.hand_W(), this->mesh_.led_W() };
    this->state_.push_N = this->hand_N_.head<3>();
    this->state_.turning_N = this->hand_N_.tail<3>();
    this->state_.capped = this->laws_.capped() || this->standing_.stopsAt();
    this->state_.placed = true;
    this->result_.ahead = this->mesh_.isBehind() || this->standing_.stopsAt();
    this->result_.pose_W = this->state_.pose_W;
    this->result_.rows = this->laws_.rows().count;
    this->result_.found = this->plan_.lawCount - this->named_.lawCount;
    this->result_.work = this->laws_.work() + this->standing_.work();
    this->result_.capped = this->laws_.capped();
    this->result_.residual_u = this->laws_.residual_u();
    this->result_.stored_Nu = this->laws_.stored_Nu();
  }

  void keepBody(int b) noexcept
  {
    const Pose moved_W = this->laws_.movedPose(b);
    if (!isLoose(this->plan_.bodies[b]))
    {
      this->state_.pose_W[b] = moved_W;
      return;
    }
    const bool slept = this->state_.loose[b].asleep;
    const double share = this->laws_.shareOfLoose(b);
    const Pose before_W = this->state_.pose_W[b], at_W = share < 1.0 ? partOfWay(before_W, moved_W, share) : moved_W;
    const double away_u = (at_W.p - this->plan_.bodies[b].pose_W.p).norm();
    this->state_.loose[b] = motionAfter(this->plan_, this->plan_.bodies[b], this->state_.loose[b],
      { share * this->laws_.motion(b), before_W.q, away_u }, this->input_.dt_s);
    this->state_.pose_W[b] = slept && this->state_.loose[b].asleep ? before_W : at_W;
  }

  void keepConstraint(int l) noexcept
  {
    ConstraintState& law = this->state_.laws[l];
    ConstraintNow& now = this->result_.laws[l];
    const bool has = this->laws_.rowsOf(l) > 0;
    const ConstraintOutcome outcome = has ? this->laws_.outcome(l) : ConstraintOutcome{};
    law.force_W = outcome.force_W;
    law.seen = has;
    if (has)
    {
      law.stuck_u = outcome.rest_u;
      law.met = law.met && (law.phase == ConstraintPhase::Inside || outcome.push_N > 0.0);
      law.placed = law.met || this->plan_.laws[l].kind != ConstraintKind::Puncture;
    }
    if (law.phase != ConstraintPhase::Gone && law.phase != ConstraintPhase::Inside)
    {
      const bool holds = this->plan_.laws[l].kind == ConstraintKind::Puncture ? law.met : outcome.holds;
      law.phase = outcome.slips ? ConstraintPhase::Slips : holds ? ConstraintPhase::Closed : ConstraintPhase::Open;
    }
    now.phase = has && inShaft(this->plan_.laws[l], law) ? ConstraintPhase::Inside : law.phase;
    now.force_W = law.force_W;
    now.inside_u = now.phase == ConstraintPhase::Inside ? law.stuck_u.x() : 0.0;
    now.at_W = this->placeOf(l);
  }

  /// Of the side that is rigid, as it has moved.
  [[nodiscard]] Vec3 placeOf(int l) const noexcept
  {
    const auto& [a, b] = this->laws_.rows().ends[l];
    const ConstraintEnd& end = a.soft < 0 ? a : b;
    const Pose& from = this->laws_.reference_W(end.body);
    const Pose& to = this->state_.pose_W[end.body];
    return end.soft < 0 ? to * into(from, end.x_W) : end.x_W;
  }

  /// A tip that is pressed on follows the surface.
  void slide(int l) noexcept
  {
    ConstraintState& law = this->state_.laws[l];
    const PressedBody* soft = this->softOf(this->plan_.laws[l].b);
    const bool slides = this->plan_.laws[l].kind == ConstraintKind::Puncture && this->plan_.laws[l].friction == 0.0;
    if (!slides || !law.met || law.phase == ConstraintPhase::Inside || !soft)
    {
      return;
    }
    const Vec3 apart_W = this->placeOf(l) + law.apart_W + law.offset_W;
    const Vec3 aside_W = apart_W - law.normal_W.dot(apart_W) * law.normal_W;
    law.place_B.x_W = this->laws_.rows().ends[l][1].x_W;
    if (!slideOnSurface(*soft, aside_W, law)) // beyond an edge nothing is below the tip any more
    {
      law.met = law.placed = false;
      law.phase = ConstraintPhase::Open;
    }
  }

  void tellPresses(int l) noexcept
  {
    for (int side = 0; side < 2; ++side)
    {
      const ConstraintEnd& end = this->laws_.rows().ends[l][side];
      const Vec3& force_W = this->state_.laws[l].force_W;
      if (end.soft >= 0 && force_W != Vec3::Zero())
      {
        this->result_.presses[this->result_.pressCount++] = { end.soft, this->laws_.rows().ends[l][1 - side].body,
          end.point.at, side == 0 ? force_W : Vec3(-force_W) };
      }
    }
  }

  void tellHand(const Vec6& before_N, bool changed) noexcept
  {
    const double k = this->input_.grip.coupling_N_per_u;
    const Vec6 now_N = this->hand_N_;
    const Vec6 step_u = changed ? Vec6((now_N - before_N) / k) : Vec6(Vec6::Zero());
    const Vec6 felt_N = k * this->state_.blend.blended(now_N / k, step_u, k, this->input_.dt_s);
    const auto wrench = [this](const Vec6& f) {
      return Wrench{ f.head<3>(), this->plan_.characteristic_u * f.tail<3>() };
    };
    this->result_.exact_W = wrench(now_N);
    this->result_.wrench_W = wrench(felt_N);
  }

  MechanismInput input_; ///< where the turn is held, with a spring that holds it
  const MechanismPlan& named_;
  const MechanismPlan& plan_;
  MechanismPlan& joined_;
  MechanismState& state_;
  MechanismResult& result_;
  Vec6 hand_N_ = Vec6::Zero(); ///< of the held body on the hand, whitened
  Vec3 tip_W_ = Vec3::Zero();
  std::array<bool, Mechanism::mostConstraints> tried_{};
  SettledConstraints laws_;
  FollowingMesh mesh_;
  StandingContacts standing_;
};

} // namespace

void beginAnew(const MechanismPlan& plan, MechanismState& state) noexcept
{
  state = {};
  state.revision = plan.revision;
  for (int b = 0; b < plan.bodyCount; ++b)
  {
    state.pose_W[b] = plan.bodies[b].pose_W;
  }
  for (int l = 0; l < plan.lawCount; ++l)
  {
    state.laws[l].place_A = plan.laws[l].place_A;
    state.laws[l].place_B = plan.laws[l].place_B;
    state.laws[l].waits = mayGiveWay(plan.laws[l]) && (plan.laws[l].a == plan.held || plan.laws[l].b == plan.held);
  }
}

MechanismTick::MechanismTick() : room_(std::make_unique<MechanismScratch>()) {}
MechanismTick::~MechanismTick() = default;
MechanismTick::MechanismTick(MechanismTick&&) noexcept = default;
MechanismTick& MechanismTick::operator=(MechanismTick&&) noexcept = default;

const MechanismResult& MechanismTick::step(const MechanismInput& input) noexcept
{
  if (input.plan == nullptr || !isSound(input.hand_W) || !(input.grip.coupling_N_per_u > 0.0))
  {
    this->room_->result = {};
    return this->room_->result;
  }
  if (input.plan->revision != this->state_.revision)
  {
    beginAnew(*input.plan, this->state_);
  }
  if (input.plan->wire)
  {
    stepWire(input, this->room_->wire, this->state_, this->room_->result);
    return this->room_->result;
  }
  MechanismInput joined = input;
  if (input.found != nullptr || input.meshes != nullptr || this->state_.found.answer != 0)
  {
    joinFound(
      *input.plan, this->state_.found, this->state_.pose_W, this->room_->joined, StandingGuard(input.meshes).rest_u());
    joined.plan = &this->room_->joined;
  }
  MechanismStep(joined, *input.plan, this->state_, *this->room_).run();
  return this->room_->result;
}

void MechanismTick::breakConstraint(std::uint32_t law) noexcept
{
  if (law < this->state_.laws.size())
  {
    this->state_.laws[law].phase = ConstraintPhase::Gone;
  }
}

} // namespace palpate
