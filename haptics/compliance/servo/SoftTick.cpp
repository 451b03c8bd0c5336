// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/servo/SoftTick.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "haptics/compliance/servo/ContactYield.h"
#include "haptics/compliance/servo/SharedDents.h"
#include "haptics/compliance/servo/SoftContacts.h"
#include "haptics/contact/GodObject.h"
#include "haptics/core/Across.h"

namespace palpate
{
namespace
{

constexpr int mostLoops = 120;
/// Iterations that do not agree by then pass the ball from face to face.
constexpr int usualLoops = 8;
/// Parts of the path of such a tick, or of one in which the force steps by more than this share of it.
constexpr int parts = 8;
constexpr double stepShare = 0.1;
/// Least and largest relaxation of an iteration.
constexpr double leastShare = 0.1;
constexpr double mostShare = 8.0;
constexpr double shareBeyond = 1.5;
/// Two iterations that differ by less than this share of a patch agree: 1e-10 m of 25 mm.
constexpr double agreeWithin = 4e-9;
/// The first step to a force: a dent takes at least the force that moves the coupling by this share of a patch.
constexpr double leastDepth = 1e-6;
/// Newton's steps on the springs below the patches, for all contacts together; five are usual.
constexpr int mostSprings = 30;
/// A residual of so many times rounding is no solution.
constexpr double unsolved = 1e4;
/// Cost of the compliance of two points for each other, twice per iteration: in the unit of ContactPlan::workBudget.
constexpr std::uint32_t workOfPairs = 10;
/// Number of secants at their beginning: from a force ten times too large they lead within a tenth.
constexpr int secants = 3;

Mat3 basisOf(const Vec3& n) noexcept
{
  const auto [first, second] = tangentsOf(n);
  Mat3 basis;
  basis << n, first, second;
  return basis;
}

/// The contacts of one iteration as a problem in their own directions.
class TurnProblem
{
public:
  TurnProblem(double coupling_N_per_u, double radius_u, double friction, SoftState& state, SoftScratch& room) noexcept
    : coupling_(coupling_N_per_u), radius_u_(radius_u), state_(state), room_(room), dents_(contactsOf(state))
  {
    room.problem.resize(state.count);
    room.problem.friction = friction;
    for (int c = 0; c < state.count; ++c)
    {
      this->basis_[c] = basisOf(state.contacts[c].n);
    }
    const Mat3 device = Mat3::Identity() / coupling_N_per_u;
    for (int c = 0; c < state.count; ++c)
    {
      for (int d = 0; d <= c; ++d)
      {
        const Mat3 w =
          this->basis_[c].transpose() * (complianceOf(state.contacts[c], state.contacts[d]) + device) * this->basis_[d];
        room.problem.compliance.block<3, 3>(3 * c, 3 * d) = w;
        room.problem.compliance.block<3, 3>(3 * d, 3 * c) = w.transpose();
        this->bare_[c][d] = w;
      }
    }
  }

  /// Forces of all contacts for a device at p, slip measured from the ball's old place in the material. Adds its work
  /// to `work`, and ends when that has reached `budget`.
  void solve(const Vec3& p_W, const Vec3& slipFrom_W, std::uint32_t budget, std::uint32_t& work) noexcept
  {
    work += workOfPairs * static_cast<std::uint32_t>(this->state_.count * this->state_.count);
    for (int i = 0; i < mostSprings && (i == 0 || work < budget); ++i)
    {
      // The dents are linearised: first by secants from zero to the last force, which always lead nearer, then by
      // tangents of the springs there, which converge in a few steps.
      const bool agreed = this->dents_.press(
        i < secants ? SharedDents::Line::Secant : SharedDents::Line::Tangent, leastDepth * this->coupling_);
      if (agreed && i > 0)
      {
        return;
      }
      this->linearise(p_W, slipFrom_W);
      this->solveOnce(budget - std::min(budget, work));
      work += this->room_.forces.work;
      this->takeForces();
      if (i >= secants && this->room_.forces.residual_u > unsolved * this->room_.forces.tolerance_u)
      {
        return; // forces that violate the laws lead no nearer
      }
    }
  }

private:
  void linearise(const Vec3& p_W, const Vec3& slipFrom_W) noexcept
  {
    ContactProblem& problem = this->room_.problem;
    for (int c = 0; c < this->state_.count; ++c)
    {
      const SoftContact& contact = this->state_.contacts[c];
      const double gap = contact.n.dot(p_W - contact.foot_W) - this->radius_u_;
      problem.free[3 * c] = gap + contact.n.dot(this->dents_.depthAt(c));
      for (int d = 0; d < this->state_.count; ++d)
      {
        const SoftContact& other = this->state_.contacts[d];
        const double slope = this->dents_.slopeBetween(c, d);
        problem.compliance(3 * c, 3 * d) = this->bareBetween(c, d)(0, 0) + slope;
        // The tangential compliance of the dents is in proportion to the force there: no residual is left.
        problem.compliance.block<2, 2>(3 * c + 1, 3 * d + 1) =
          this->bareBetween(c, d).bottomRightCorner<2, 2>() +
          this->dents_.acrossBetween(c, d) *
            (this->basis_[c].rightCols<2>().transpose() * this->basis_[d].rightCols<2>());
        problem.free[3 * c] -= slope * other.n.dot(other.force_N);
      }
      problem.free.segment<2>(3 * c + 1) =
        this->basis_[c].rightCols<2>().transpose() * (p_W - slipFrom_W - contact.aside_W);
    }
  }

  [[nodiscard]] Mat3 bareBetween(int c, int d) const noexcept
  {
    return d <= c ? this->bare_[c][d] : Mat3(this->bare_[d][c].transpose());
  }

  void solveOnce(std::uint32_t budget) noexcept
  {
    ContactForces& forces = this->room_.forces;
    if (this->room_.problem.friction == 0.0)
    {
      solveGaps(this->room_.problem, forces);
      return;
    }
    forces.force_N.resize(3 * this->state_.count);
    for (int c = 0; c < this->state_.count; ++c)
    {
      forces.force_N.segment<3>(3 * c) = this->basis_[c].transpose() * this->state_.contacts[c].force_N;
    }
    solveFriction(this->room_.problem, this->room_.friction, forces, budget);
  }

  void takeForces() noexcept
  {
    for (int c = 0; c < this->state_.count; ++c)
    {
      const Vec3 local = this->room_.forces.force_N.segment<3>(3 * c);
      this->state_.contacts[c].force_N = this->basis_[c] * local;
    }
  }

  double coupling_;
  double radius_u_;
  SoftState& state_;
  SoftScratch& room_;
  SharedDents dents_;
  static constexpr std::size_t most = GodObjectState::maxFeatures;
  std::array<Mat3, most> basis_;
  std::array<std::array<Mat3, most>, most> bare_; ///< compliance without the dents, for d <= c
};

/// Aitken's relaxation: the factor on the residual, from the change that the last step made in it. Where the iterations
/// converge slowly it extrapolates, where two walls pass the ball to each other it stops between them.
class TurnSteps
{
public:
  [[nodiscard]] double shareOf(const Vec3& off_u) noexcept
  {
    const Vec3 changed_u = off_u - this->before_u_;
    if (const double size = changed_u.squaredNorm(); this->started_ && size > 0.0)
    {
      const double share = -this->share_ * this->before_u_.dot(changed_u) / size;
      // The residual grew: the equilibrium lies beyond.
      this->share_ = share > 0.0 ? std::clamp(share, leastShare, mostShare) : shareBeyond;
    }
    this->before_u_ = off_u;
    this->started_ = true;
    return this->share_;
  }

private:
  Vec3 before_u_ = Vec3::Zero();
  double share_ = 1.0;
  bool started_ = false;
};

/// The iterations of one tick between the core among the free surfaces and the forces of its contacts.
template<SceneView AnyScene>
class SoftMove
{
public:
  SoftMove(const AnyScene& scene, const ContactPlan& plan, std::span<const SoftSurfaceRef> soft, const Vec3& p_W,
    SoftState& state, SoftScratch& room) noexcept
    : scene_(scene), plan_(plan), soft_(soft), drawn_W_(p_W - state.offset_W), state_(state), room_(room),
      opens_(state.core.around.content != sceneOf(scene).contentHash() || state.core.around.skips), start_(state.core),
      slipStart_(state), soften_(givesWay(state))
  {
  }

  [[nodiscard]] SoftResult run() noexcept
  {
    SoftState before = this->state_;
    bool agrees = this->takeTurns(usualLoops - 1);
    const Way way = this->wayFrom(before);
    if (way.pressed && !this->result_.overBudget && (!agrees || this->steps(way)))
    {
      agrees = this->goInParts(before, way);
    }
    if (!agrees && !this->result_.overBudget)
    {
      this->goOnFromHere();
      agrees = this->takeTurns(mostLoops);
    }
    this->result_.capped = !agrees && !this->result_.overBudget;
    this->result_.proxy_W = this->soften_ ? this->ball_W() : Vec3(this->state_.core.x_W + this->state_.offset_W);
    this->result_.force_N = this->force_N_;
    return this->result_;
  }

private:
  /// The path of the device in this tick: from the point for which the previous ball would be at rest.
  struct Way
  {
    Vec3 from_W = Vec3::Zero();
    Vec3 to_W = Vec3::Zero();
    Vec3 force_N = Vec3::Zero(); ///< at its begin
    bool pressed = false;        ///< whether a soft contact carried force there
  };

  [[nodiscard]] Way wayFrom(const SoftState& before) const noexcept
  {
    Way way;
    way.to_W = this->drawn_W_;
    for (const SoftContact& contact : contactsOf(before))
    {
      way.force_N += contact.force_N;
      way.pressed = way.pressed || (contact.gives && contact.force_N.squaredNorm() > 0.0);
    }
    way.from_W = before.core.x_W + before.yielded_W - way.force_N / this->plan_.coupling_N_per_m;
    return way;
  }

  /// True if the force has changed by more than the device's path explains, and a tenth of it.
  [[nodiscard]] bool steps(const Way& way) const noexcept
  {
    const double most_N = std::max(way.force_N.norm(), this->force_N_.norm());
    return (this->force_N_ - way.force_N).norm() >
           this->plan_.coupling_N_per_m * (way.to_W - way.from_W).norm() + stepShare * most_N;
  }

  /// Iterations extrapolate, and may come over an edge to a face that the ball never reaches. Along the path in short
  /// parts each equilibrium is beside the one before: a step that remains is a step of the contact law itself.
  [[nodiscard]] bool goInParts(SoftState& before, const Way& way) noexcept
  {
    before.core.around = this->state_.core.around; // faces are where they are, wherever the ball goes on from
    this->state_ = before;
    this->soften_ = givesWay(before);
    this->force_N_ = way.force_N;
    bool agrees = true;
    for (int part = 1; part <= parts && agrees; ++part)
    {
      this->goOnFromHere();
      this->drawn_W_ = way.from_W + static_cast<double>(part) / parts * (way.to_W - way.from_W);
      agrees = this->takeTurns(usualLoops - 1);
    }
    this->drawn_W_ = way.to_W;
    return agrees;
  }

  /// At most `most` iterations. True once core and forces agree.
  [[nodiscard]] bool takeTurns(int most) noexcept
  {
    bool agrees = false;
    for (int i = 1; i <= most && this->result_.loops < mostLoops && !agrees && !this->result_.overBudget; ++i)
    {
      ++this->result_.loops;
      if (i % usualLoops == 0)
      {
        this->goOnFromHere();
      }
      this->moveCore();
      agrees = givesWay(this->state_) ? this->turn() : this->letGo();
      this->result_.overBudget = !agrees && this->result_.work >= this->plan_.workBudget;
    }
    return agrees;
  }

  /// The ball for which the contacts were solved, among the displaced surfaces.
  [[nodiscard]] Vec3 ball_W() const noexcept
  {
    return this->drawn_W_ + this->state_.offset_W + this->force_N_ / this->plan_.coupling_N_per_m;
  }

  /// Over a bend friction holds the ball by other planes than those along which it slid there. The path so far
  /// is done, and core and slip begin anew from here.
  void goOnFromHere() noexcept
  {
    this->start_ = this->state_.core;
    this->slipStart_ = SlipStart(this->state_);
    this->steps_ = TurnSteps{};
  }

  /// Uses the rest of the tick's work; friction of soft contacts belongs to the problem.
  void moveCore() noexcept
  {
    ContactPlan plan = this->plan_;
    plan.friction = this->soften_ ? FrictionPlan{} : plan.friction;
    plan.workBudget -= std::min(plan.workBudget, this->result_.work);
    static_cast<TouchingBall&>(this->state_.core) = this->start_;
    this->state_.core.around.skips = this->opens_ || this->result_.loops > 1; // turns of one tick make one list
    this->result_.core = moveGodObject(
      this->scene_, plan, this->drawn_W_ - this->state_.yielded_W + this->state_.lead_W, this->state_.core);
    this->result_.work += this->result_.core.work;
    gatherContacts(this->scene_, this->soft_, plan.radius_u, this->state_);
    this->slipStart_.tell(this->state_);
  }

  /// The rigid core alone, for a ball that touches no soft surface. False while a surface from before carries it
  /// away.
  [[nodiscard]] bool letGo() noexcept
  {
    const bool rigid = !this->soften_;
    this->soften_ = false;
    this->state_.yielded_W = this->state_.lead_W = Vec3::Zero();
    // Without carrying, the core's pull is that of its present position.
    this->force_N_ =
      this->plan_.coupling_N_per_m * (rigid ? this->result_.core.pull_W : Vec3(this->state_.core.x_W - this->drawn_W_));
    return rigid;
  }

  /// Solves the contacts; true if core and forces agree.
  [[nodiscard]] bool turn() noexcept
  {
    SoftState& state = this->state_;
    this->solve();
    const int met = state.count;
    state.count = pressingFirst(state);
    if (state.count > 0 && state.count < met)
    {
      // A point that is touched and not pressed has no part in a dent.
      this->solve();
    }
    Yield now = yieldUnder(state);
    state.count = met;
    const Vec3 ball_W = this->drawn_W_ + now.force_N / this->plan_.coupling_N_per_m;
    CommonYield common(state, now.yielded_W);
    common.stayOut(ball_W, this->plan_.radius_u);
    now.yielded_W = common.u_W();
    const Vec3 lead_W = now.across_N / this->plan_.coupling_N_per_m;
    const Vec3 change_u = now.yielded_W - lead_W - state.yielded_W + state.lead_W;
    const double off_u = std::min(change_u.norm(), (state.core.x_W + now.yielded_W - ball_W).norm()) +
                         (now.force_N - this->force_N_).norm() / this->plan_.coupling_N_per_m;
    const bool agrees = off_u <= agreeWithin * patchUnder(state);
    const double share = this->soften_ && !agrees ? this->steps_.shareOf(change_u) : 1.0;
    state.yielded_W += share * (now.yielded_W - state.yielded_W);
    state.lead_W += share * (lead_W - state.lead_W);
    this->soften_ = true;
    this->force_N_ = now.force_N;
    this->result_.residual_u = this->room_.forces.residual_u;
    return agrees;
  }

  void solve() noexcept
  {
    TurnProblem problem(
      this->plan_.coupling_N_per_m, this->plan_.radius_u, this->plan_.friction.kinetic, this->state_, this->room_);
    this->result_.slipFrom_W = this->start_.placed ? this->start_.x_W : this->state_.core.x_W;
    problem.solve(this->drawn_W_, this->result_.slipFrom_W, this->plan_.workBudget, this->result_.work);
  }

  const AnyScene& scene_;
  const ContactPlan& plan_;
  std::span<const SoftSurfaceRef> soft_;
  Vec3 drawn_W_;
  SoftState& state_;
  SoftScratch& room_;
  bool opens_;         ///< this tick is the first one of its scene
  TouchingBall start_; ///< of a turn
  SlipStart slipStart_;
  bool soften_; ///< the core is moved by displaced surfaces
  TurnSteps steps_;
  Vec3 force_N_ = Vec3::Zero();
  SoftResult result_;
};

} // namespace

template<SceneView AnyScene>
SoftResult moveOnSoft(const AnyScene& scene, const ContactPlan& plan, std::span<const SoftSurfaceRef> soft,
  const Vec3& p_W, SoftState& state, SoftScratch& room) noexcept
{
  return SoftMove<AnyScene>(scene, plan, soft, p_W, state, room).run();
}

void changeSnapshots(std::span<const SoftSurfaceRef> now, SoftState& state) noexcept
{
  for (int c = 0; c < state.count; ++c)
  {
    SoftContact& contact = state.contacts[c];
    const auto isIts = [&contact](const SoftSurfaceRef& touch) { return touch.surface == contact.feature.surface; };
    const auto touch = std::ranges::find_if(now, isIts);
    contact.soft = contact.soft && touch != now.end() ? &*touch : nullptr; // a body that is gone has no compliance
    contact.gives = contact.gives && contact.soft != nullptr;
    if (contact.soft)
    {
      contact.point = compliantPoint(*touch->snapshot, contact.point.at);
      contact.spring = springAt(*touch->snapshot, contact.point.at);
    }
  }
  const Vec3 before_W = state.yielded_W;
  state.yielded_W = CommonYield(state, yieldUnder(state).yielded_W).u_W();
  state.offset_W += before_W - state.yielded_W;
  state.lead_W = givesWay(state) ? state.lead_W : Vec3(Vec3::Zero());
}

void fadeChange(double dt_s, SoftState& state) noexcept
{
  state.offset_W *= snapshotFade.explicitShare(dt_s);
}

template SoftResult moveOnSoft(
  const Scene&, const ContactPlan&, std::span<const SoftSurfaceRef>, const Vec3&, SoftState&, SoftScratch&) noexcept;
template SoftResult moveOnSoft(const MovingScene&, const ContactPlan&, std::span<const SoftSurfaceRef>, const Vec3&,
  SoftState&, SoftScratch&) noexcept;

} // namespace palpate
