// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/wire/WireTick.h"

#include <algorithm>
#include <cmath>

#include "haptics/core/Across.h"
#include "haptics/core/PoseMath.h"
#include "haptics/mechanism/SoundPose.h"
#include "haptics/mechanism/wire/WireHand.h"
#include "haptics/mechanism/wire/WireProof.h"
#include "haptics/mechanism/wire/WireScratch.h"
#include "haptics/mechanism/wire/WireSheath.h"

namespace palpate
{

namespace
{

/// Newton steps in a tick: each takes the first ones; the last is for a wire that the step before has led far, and for
/// ticks with little work so far, in the unit of ContactPlan::workBudget.
constexpr int usualSteps = 2, mostSteps = 3;
constexpr std::uint32_t thirdBelow = 30000;
/// Of the radius: so far a step leads the outer end that another one follows.
constexpr double ledFar = 0.02;
/// Wire radii around the shaft, and around the tip, in which contacts are looked for at least.
constexpr double leastReach = 0.3, leastTipReach = 0.4;
/// Of the way that the hand goes in a tick: the tip goes on by it, the shaft slides along itself.
constexpr double reachOfWay = 0.75, tipReachOfWay = 1.5;
/// Wire radii that the hand leads the wire in a tick, at most.
constexpr double mostWay = 1.0;
/// Of the compliance of a beam that is clamped at both ends, in its middle: so much each contact has of its own, so
/// that two at one node have one answer.
constexpr double evenly = 1e-3;
/// Of a beam's stiffness across itself: drag of the nodes near a wall across the wire, towards where a step begins.
/// Planes know nothing of a wall that is hollow, and on them a bent wire rolls over.
constexpr double dragged = 1e-2;
/// Of the radius: contacts that are no further apart are solved from the beginning.
constexpr double metAt = 0.01;
/// Likewise those of beams that pressed before.
constexpr double pressedAt = 0.1;
constexpr std::uint8_t aboutX = 0b001000;
/// Of the radius: contacts that miss their laws by no more are met.
constexpr double metWithin = 1e-6;
/// Likewise: so near to the laws the solver goes.
constexpr double enough = 1e-11;

/// One tick.
class WireStep
{
public:
  WireStep(const WireInput& input, WireScratch& room) noexcept
    : input_(input), plan_(*input.plan), room_(room), state_(room.state), result_(room.result)
  {
  }

  void run() noexcept
  {
    this->result_ = {};
    if (this->state_.revision != this->plan_.revision || !this->state_.placed)
    {
      this->begin();
    }
    if (this->room_.vesselHash != this->plan_.vessel->contentHash())
    {
      this->room_.vessel.forget();
      this->room_.vesselHash = this->plan_.vessel->contentHash();
    }
    this->takeHand();
    this->room_.since.fill(NodeVector::Zero());
    this->room_.begun = this->state_.presses;
    this->room_.begunCount = this->state_.pressCount;
    for (int i = 0; i < mostSteps && this->mayGoOn(i); ++i)
    {
      this->goOn(i == 0);
    }
    this->tell();
  }

private:
  void begin() noexcept
  {
    this->state_ = {};
    this->state_.revision = this->plan_.revision;
    this->state_.placed = true;
    this->state_.places_M = placesInSheath(this->plan_);
    this->state_.grip_u = handAlong_u(this->input_);
    this->state_.hand_W = this->input_.hand_W.q;
  }

  void takeHand() noexcept
  {
    const double r = this->plan_.radius_u;
    const double way_u = takeWireHand(this->input_, mostWay * r, this->state_);
    this->result_.capped = this->state_.led_u != handAlong_u(this->input_) - this->state_.grip_u;
    this->reach_.shaft_u = std::max(reachOfWay * std::abs(way_u), leastReach * r);
    this->reach_.tip_u = std::max(tipReachOfWay * std::abs(way_u), leastTipReach * r);
  }

  /// Where the hand leads the outer end. The outer end stays in the sheath, where the handle meets the mouth.
  [[nodiscard]] double ledTo_u() const noexcept
  {
    constexpr double beamsInSheath = 1.5;
    return std::min(this->state_.led_u - this->plan_.length_u(), -beamsInSheath * this->plan_.wire.beams[0].length_u);
  }

  [[nodiscard]] bool mayGoOn(int steps) noexcept
  {
    if (steps >= usualSteps &&
        (this->result_.work > thirdBelow || std::abs(this->room_.motion[0][0]) <= ledFar * this->plan_.radius_u))
    {
      return false;
    }
    const bool more = this->result_.work < this->input_.budget && !this->stuck_;
    this->result_.capped = this->result_.capped || !more;
    return more;
  }

  /// The places of the sheath are those that contacts were looked for at, but for rounding onto its axis.
  void hold() noexcept
  {
    WireLoads& loads = this->room_.loads;
    holdInSheath(this->plan_.wire, this->state_.places_M, loads);
    loads.force[0][0] = this->input_.coupling_N_per_u * (this->ledTo_u() - this->state_.places_M[0].p.x());
    loads.falls[0][0] = this->input_.coupling_N_per_u;
    loads.acrossDrag_N_per_u.fill(0.0);
    for (int i = 0; i < this->room_.near.count; ++i)
    {
      this->dragBeside(this->room_.near.all[i]);
    }
    if (this->input_.turning_Nu_per_rad > 0.0)
    {
      loads.force[0][3] = this->input_.turning_Nu_per_rad * (this->state_.handTurn_rad - this->state_.turned_rad);
      loads.falls[0][3] = this->input_.turning_Nu_per_rad;
      return;
    }
    loads.held[0] |= aboutX;
  }

  /// A wall that ends the wire's way does not hold its tip: a wire that presses it buckles at once.
  void dragBeside(const WireContact& contact) noexcept
  {
    const WireBeam& beam = this->plan_.wire.beams[contact.beam];
    const double ahead = contact.normal_M.dot(chordOf(this->state_.places_M, contact.beam).normalized());
    const double across_N_per_u = 12.0 * beam.section.bend_Nu2 / (beam.length_u * beam.length_u * beam.length_u);
    const double drag_N_per_u = dragged * (1.0 - ahead * ahead) * across_N_per_u;
    for (double* const node :
      { &this->room_.loads.acrossDrag_N_per_u[contact.beam], &this->room_.loads.acrossDrag_N_per_u[contact.beam + 1] })
    {
      *node = std::max(*node, drag_N_per_u);
    }
  }

  /// One Newton step with its contacts.
  void goOn(bool first) noexcept
  {
    WireNewton& newton = this->room_.newton;
    this->room_.vessel.find(this->plan_, this->state_.places_M, this->reach_, this->room_.near);
    this->result_.work += searchWork(this->room_.near.looked, this->room_.near.queries);
    this->hold();
    this->stuck_ = !newton.linearise(this->plan_.wire, this->state_.places_M, this->room_.loads);
    if (this->stuck_)
    {
      this->result_.capped = true;
      return;
    }
    this->result_.work += newtonWork(this->plan_.wire.nodes(), newton.factors());
    newton.factor().invert();
    newton.step(this->room_.free);
    this->count(first);
    this->press();
    this->result_.leftOut = std::max(this->result_.leftOut, this->leftOut_);
    this->move();
  }

  void count(bool first) noexcept
  {
    const WireContacts& near = this->room_.near;
    this->result_.queries += near.queries;
    this->result_.looked += near.looked;
    this->result_.crowded = std::max(this->result_.crowded, near.crowded);
    for (int b = 0; b < this->plan_.wire.count && first; ++b)
    {
      this->result_.deepest_u = std::max(this->result_.deepest_u, this->plan_.radius_u - near.away_u[b]);
    }
  }

  /// Contacts that press: those of beams that pressed before and those that are met, then, as the wire goes, others
  /// that it would go through.
  void press() noexcept
  {
    constexpr int mostRounds = 3;
    this->chooseFirst();
    this->solve();
    for (int i = 1; i < mostRounds && this->chooseMore(); ++i)
    {
      this->solve();
    }
  }

  [[nodiscard]] bool pressedBefore(int beam) const noexcept
  {
    const auto end = this->state_.presses.begin() + this->state_.pressCount;
    return std::any_of(this->state_.presses.begin(), end, [beam](const WirePress& p) { return p.beam == beam; });
  }

  void chooseFirst() noexcept
  {
    const WireContacts& near = this->room_.near;
    this->contacts_ = 0;
    for (const double within_u : { metAt * this->plan_.radius_u, -std::numeric_limits<double>::infinity() })
    {
      for (int i = 0; i < near.count; ++i)
      {
        const bool first = near.all[i].gap_u <= within_u;
        const bool again = std::isinf(within_u) && !this->room_.isChosen[i] &&
                           near.all[i].gap_u <= pressedAt * this->plan_.radius_u &&
                           this->pressedBefore(near.all[i].beam);
        this->room_.isChosen[i] = std::isinf(within_u) ? this->room_.isChosen[i] : false;
        this->choose(i, first || again);
      }
    }
  }

  void choose(int contact, bool wanted) noexcept
  {
    if (wanted && this->contacts_ < WireTouch::most)
    {
      this->room_.isChosen[contact] = true;
      ++this->contacts_;
    }
  }

  /// How far the wire's skin is from the wall of a contact after the step.
  [[nodiscard]] double gapAfter_u(const WireContact& contact) const noexcept
  {
    return contact.gap_u + motionAt(this->touchOf(contact), this->room_.motion).x();
  }

  /// Whether there are any; those for which there is no room are counted.
  [[nodiscard]] bool chooseMore() noexcept
  {
    const WireContacts& near = this->room_.near;
    const int before = this->contacts_;
    this->leftOut_ = 0;
    for (int i = 0; i < near.count; ++i)
    {
      const bool through =
        !this->room_.isChosen[i] && this->gapAfter_u(near.all[i]) < -metWithin * this->plan_.radius_u;
      this->choose(i, through);
      this->leftOut_ += through && !this->room_.isChosen[i] ? 1 : 0;
    }
    return this->contacts_ > before;
  }

  /// The first tangent runs along the beam.
  [[nodiscard]] WireTouch touchOf(const WireContact& contact) const noexcept
  {
    constexpr double leastAcross = 1e-3; // of a direction along the wire, across a normal
    const Vec3& n = contact.normal_M;
    const Vec3 beam_M =
      (this->state_.places_M[contact.beam + 1].p - this->state_.places_M[contact.beam].p).normalized();
    const Vec3 across_M = beam_M - n.dot(beam_M) * n;
    const Vec3 t = across_M.norm() > leastAcross ? Vec3(across_M.normalized()) : acrossOf(n);
    return { contact.beam, contact.share, -this->plan_.radius_u * n, (Mat3() << n, t, n.cross(t)).finished() };
  }

  /// The chosen contacts on the linear wire, and its motion with their forces.
  void solve() noexcept
  {
    ContactProblem& problem = this->room_.problem;
    ContactForces& forces = this->room_.forces;
    int n = 0;
    for (int i = 0; i < this->room_.near.count; ++i)
    {
      if (this->room_.isChosen[i])
      {
        this->room_.chosen[n] = &this->room_.near.all[i];
        this->room_.touches[n++] = this->touchOf(this->room_.near.all[i]);
      }
    }
    const std::span chosen(this->room_.chosen.data(), static_cast<std::size_t>(n));
    const std::span begun(this->room_.begun.data(), static_cast<std::size_t>(this->room_.begunCount));
    const std::span last(this->state_.presses.data(), static_cast<std::size_t>(this->state_.pressCount));
    const std::span touches(this->room_.touches.data(), static_cast<std::size_t>(n));
    problem.resize(n);
    problem.friction = this->plan_.friction;
    problem.compliance.setZero();
    addWireCompliance(this->room_.newton.factor(), touches, problem.compliance);
    forces.force_N.setZero(3 * n);
    for (int i = 0; i < n; ++i)
    {
      // Across the normal its own compliance keeps the force with which the tick began: else all that sticks creeps.
      const Vec3 since =
        motionAt(touches[i], this->room_.since) - this->own_u_per_N(touches[i].beam) * goesOn_N(chosen, i, begun);
      problem.free.segment<3>(3 * i) = motionAt(touches[i], this->room_.free) + Vec3(0.0, since.y(), since.z());
      problem.free[3 * i] += this->room_.chosen[i]->gap_u;
      problem.compliance.diagonal().segment<3>(3 * i).array() += this->own_u_per_N(touches[i].beam);
      forces.force_N.segment<3>(3 * i) = goesOn_N(chosen, i, last);
    }
    this->result_.work += touchWork(n);
    if (this->plan_.friction > 0.0)
    {
      const std::uint32_t left = this->input_.budget - std::min(this->input_.budget, this->result_.work);
      solveFriction(problem, this->room_.friction, forces, left, { enough * this->plan_.radius_u, true });
    }
    else
    {
      solveGaps(problem, forces);
    }
    this->result_.work += forces.work;
    this->result_.residual_u = forces.residual_u;
    this->room_.pressed.fill(NodeVector::Zero());
    for (int i = 0; i < n; ++i)
    {
      pressAt(touches[i], forces.force_N.segment<3>(3 * i), this->room_.pressed);
    }
    this->room_.newton.step(this->room_.pressed, this->room_.motion);
  }

  [[nodiscard]] double own_u_per_N(int beam) const noexcept
  {
    const WireBeam& b = this->plan_.wire.beams[beam];
    return evenly * b.length_u * b.length_u * b.length_u / (192.0 * b.section.bend_Nu2);
  }

  void move() noexcept
  {
    this->state_.pressCount = 0;
    for (int i = 0; i < this->contacts_; ++i)
    {
      const Vec3 force_N = this->room_.forces.force_N.segment<3>(3 * i);
      if (force_N.x() > 0.0)
      {
        const WireTouch& touch = this->room_.touches[i];
        this->state_.presses[this->state_.pressCount++] = { touch.beam, this->room_.chosen[i]->at_M, force_N,
          touch.axes_W * force_N };
      }
    }
    WireVector& motion = this->room_.motion;
    const double share = provenShare({ this->plan_, this->state_.places_M, this->room_.near, this->reach_ }, motion);
    for (int i = 0; i < this->plan_.wire.nodes(); ++i)
    {
      motion[i] *= share;
    }
    const double taken = moveWire(this->plan_.wire, motion, this->state_.places_M);
    for (int i = 0; i < this->plan_.wire.nodes(); ++i)
    {
      this->room_.since[i] += taken * motion[i];
    }
    this->state_.turned_rad += taken * motion[0][3];
    this->result_.share = std::min(this->result_.share, share * taken);
  }

  void tell() noexcept
  {
    const WirePlaces& places_M = this->state_.places_M;
    const Pose& mouth_W = this->plan_.mouth_W;
    const int last = this->plan_.wire.count;
    const double pulled_N =
      this->input_.coupling_N_per_u * (places_M[0].p.x() + this->plan_.length_u() - this->state_.led_u);
    const double turning_Nu = this->input_.turning_Nu_per_rad * (this->state_.turned_rad - this->state_.handTurn_rad);
    WireResult& result = this->result_;
    result.wrench_W.force = pulled_N * (mouth_W.q * Vec3::UnitX());
    result.wrench_W.torque = turning_Nu * (mouth_W.q * Vec3::UnitX());
    result.pushed_u = places_M[0].p.x() + this->plan_.length_u();
    result.turned_rad = this->state_.turned_rad;
    result.tip_W = mouth_W * places_M[last].p;
    result.pressCount = this->state_.pressCount;
    result.presses = this->state_.presses;
    Vec3 tip_N = Vec3::Zero();
    for (int i = 0; i < result.pressCount; ++i)
    {
      const WirePress& press = result.presses[i];
      tip_N += press.beam == last - 1 ? press.force_M : Vec3(Vec3::Zero());
      const double force_N = press.force_M.norm();
      if (force_N > result.wall_N)
      {
        result.wall_N = force_N;
        result.wall_W = mouth_W * press.at_M;
      }
    }
    result.tip_N = tip_N.norm();
    result.stored_Nu = this->room_.newton.energy_Nu();
    result.stored_Nu +=
      this->input_.coupling_N_per_u > 0.0 ? 0.5 * pulled_N * pulled_N / this->input_.coupling_N_per_u : 0.0;
    result.capped = result.capped || result.share < 1.0 || result.residual_u > metWithin * this->plan_.radius_u;
  }

  const WireInput& input_;
  const WirePlan& plan_;
  WireScratch& room_;
  WireState& state_;
  WireResult& result_;
  WireReach reach_;
  int contacts_ = 0; ///< chosen
  int leftOut_ = 0;
  bool stuck_ = false; ///< no step could be made
};

bool isUsable(const WireInput& input) noexcept
{
  return input.plan && isSound(input.hand_W) && input.coupling_N_per_u > 0.0 && std::isfinite(input.turnBy_rad);
}

} // namespace

WireTick::WireTick() : room_(std::make_unique<WireScratch>()) {}
WireTick::~WireTick() = default;
WireTick::WireTick(WireTick&&) noexcept = default;
WireTick& WireTick::operator=(WireTick&&) noexcept = default;

const WireResult& WireTick::step(const WireInput& input) noexcept
{
  if (!isUsable(input))
  {
    this->room_->result = {};
    return this->room_->result;
  }
  WireStep(input, *this->room_).run();
  return this->room_->result;
}

const WireState& WireTick::state() const noexcept
{
  return this->room_->state;
}

void WireTick::restore(const WireState& state) noexcept
{
  this->room_->state = state;
}

} // namespace palpate
