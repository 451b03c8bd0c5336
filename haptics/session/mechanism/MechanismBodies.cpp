// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/mechanism/MechanismBodies.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "haptics/core/PoseMath.h"
#include "haptics/mechanism/found/ContactFinder.h"
#include "haptics/mechanism/sided/SidedSurface.h"

namespace palpate
{
namespace
{

/// Of the mesh's size: a hand that rested goes no further until the next answer but one; so near, surfaces touch.
constexpr double usualReach = 0.25, usualTouch = 0.005;
/// So near, the mesh has contacts with meshes that stand.
constexpr double usualCover = 0.05;
/// Of a soft body's size: so near to a mesh that stands, its surface may meet the mesh until the next answer but one,
/// or touches it.
constexpr double standingReach = 0.05, standingTouch = 0.0005;
/// Of the motion since the answer before: an answer is up to two periods old, and a hand may grow faster.
constexpr double reachOfMotion = 3.0, touchOfMotion = 2.0;

/// E / (1 - nu^2) of the softest material [N/u^2].
double stiffnessOf(const SoftBodyInput& input)
{
  const double young_Pa = *std::ranges::min_element(input.young_Pa);
  return young_Pa * input.unit_m * input.unit_m / (1.0 - input.poisson * input.poisson);
}

/// Reach of a mesh in the hand whose place is not known: it meets nothing, and is held back by nothing.
constexpr double nowhere_u = -std::numeric_limits<double>::infinity();

/// Motion of a body from pose to pose: no point of it goes further.
double motionOf(double radius_u, const Pose& from_W, const Pose& to_W)
{
  const double turn = (to_W.q * from_W.q.conjugate()).vec().norm(); // half the chord of a unit arm
  return (to_W.p - from_W.p).norm() + 2.0 * radius_u * turn;
}

} // namespace

MechanismBodies::MechanismBodies() = default;
MechanismBodies::~MechanismBodies() = default;

std::unique_ptr<MechanismBodies> MechanismBodies::make(
  const std::vector<MechanismSoftInput>& inputs, std::string& refusal, const std::stop_token& stop)
{
  std::unique_ptr<MechanismBodies> made(new MechanismBodies());
  for (const MechanismSoftInput& input : inputs)
  {
    auto maker = BodyMaker::make(*input.input, input.name, 0, refusal, stop);
    BodyHand pressed;
    pressed.tip_u = input.tip_u;
    auto first = maker ? maker->press(pressed, 0.0) : nullptr;
    if (!first)
    {
      refusal = input.name + ": " + (refusal.empty() ? "its stiffness matrix is singular" : refusal);
      return nullptr;
    }
    made->asMade_.push_back(std::make_shared<const CheckedTetras>(maker->checked()));
    made->makers_.push_back(std::move(maker));
    made->newest_.push_back(std::move(first));
    made->hands_.push_back(pressed);
    made->tips_u_.push_back(input.tip_u);
    made->stiffness_.push_back(stiffnessOf(*input.input));
    made->atRest_.push_back({ input.name, made->newest_.back().get() });
    made->given_.push_back(made->newest_.back().get());
  }
  made->first_ = made->newest_;
  made->places_.resize(made->makers_.size());
  return made;
}

/// Of the plan before, where the hand has the same mesh in this one and no constraint but contacts that are found: then
/// the mesh is where it was, and its forces are those of places that this plan has, too.
std::uint64_t MechanismBodies::continues(const Mechanism& mechanism, const MechanismPlan& plan) const
{
  const SidedSurface* const had = this->finder_ ? this->finder_->held() : nullptr;
  const SidedSurface* const has =
    plan.held >= 0 ? mechanism.bodies[static_cast<std::size_t>(plan.held)].mesh.get() : nullptr;
  const bool same = had && has && this->held_ == plan.held && mechanism.laws.empty() &&
                    had->tree->contentHash() == has->tree->contentHash();
  return same ? this->plan_ : 0;
}

void MechanismBodies::makeFinder(const Mechanism& mechanism, const MechanismPlan& plan)
{
  const auto most = static_cast<std::size_t>(roomForFound(mechanism));
  std::vector<FinderMesh> meshes;
  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b)
  {
    if (mechanism.bodies[b].mesh)
    {
      const MechanismBody& body = mechanism.bodies[b];
      meshes.push_back({ static_cast<int>(b), body.mesh, foundFrictionOf(mechanism, body), isLoose(body) });
    }
  }
  this->finder_ = std::make_unique<ContactFinder>(std::move(meshes), plan.held, most);
  for (std::size_t s = 0; s < this->first_.size(); ++s)
  {
    const auto body = std::ranges::find(plan.bodies, static_cast<int>(s), &PlannedBody::soft);
    this->finder_->add(
      static_cast<int>(body - plan.bodies.begin()), *this->first_[s], this->stiffness_[s], mechanism.foundFriction);
    const SurfaceData& surface = this->first_[s]->scene->surfaces()[this->first_[s]->touch.surface].tree->data();
    this->diagonal_u_ = std::max(this->diagonal_u_, (surface.high_W - surface.low_W).norm());
  }
}

void MechanismBodies::hold(const Mechanism& mechanism, const MechanismPlan& plan)
{
  this->before_ = this->continues(mechanism, plan);
  std::ranges::transform(plan.bodies, this->begin_W_.begin(), &PlannedBody::pose_W);
  this->finder_.reset();
  std::ranges::for_each(this->makers_, [](const auto& maker) { maker->watch({}); });
  std::ranges::for_each(this->makers_, [](const auto& maker) { maker->pressParts({}); });
  this->found_ = this->underWay_ = {};
  this->looked_W_.reset();
  this->diagonal_u_ = 0.0;
  this->told_ = {};
  this->told_.pose_W = this->begin_W_;
  this->held_ = plan.held;
  this->rod_u_ = plan.held >= 0 ? plan.bodies[static_cast<std::size_t>(plan.held)].length_u : 0.0;
  this->plan_ = plan.revision;
  this->gatherMeshes(mechanism, plan);
  this->loose_.clear();
  for (int b = 0; b < plan.bodyCount; ++b)
  {
    const MechanismBody& body = mechanism.bodies[static_cast<std::size_t>(b)];
    if (isLoose(body) && body.mesh)
    {
      this->loose_.push_back(
        { b, body.mesh->radius_u, body.mesh->diagonal_u, body.load_W.norm() / body.mass.mass_Ns2_per_u });
    }
  }
  if (mechanism.findsContacts)
  {
    this->makeFinder(mechanism, plan);
  }
  this->places_.assign(this->makers_.size(), {});
  for (int i = 0; i < plan.lawCount; ++i)
  {
    const PlannedConstraint& law = plan.laws[i];
    const int softA = plan.bodies[law.a].soft;
    const int softB = plan.bodies[law.b].soft;
    if (softA >= 0)
    {
      this->places_[softA].push_back(law.place_A);
    }
    if (softB >= 0 && law.kind != ConstraintKind::Puncture) // which may be anywhere
    {
      this->places_[softB].push_back(law.place_B);
    }
  }
}

void MechanismBodies::gatherMeshes(const Mechanism& mechanism, const MechanismPlan& plan)
{
  std::vector<Surface> surfaces;
  std::vector<std::shared_ptr<const SidedSurface>> standing;
  const auto add = [&](const MechanismBody& body)
  {
    Surface surface;
    surface.name = body.name;
    surface.tree = body.mesh->tree;
    surface.material.frictionStatic = surface.material.frictionKinetic = foundFrictionOf(mechanism, body);
    surfaces.push_back(std::move(surface));
  };
  const bool holds = plan.held >= 0 && mechanism.bodies[static_cast<std::size_t>(plan.held)].mesh;
  if (holds && mechanism.findsContacts)
  {
    add(mechanism.bodies[static_cast<std::size_t>(plan.held)]);
  }
  for (const MechanismBody& body : mechanism.bodies)
  {
    if (!surfaces.empty() && body.kind == MechanismBodyKind::World && body.mesh)
    {
      add(body);
      standing.push_back(body.mesh);
    }
  }
  this->meshes_.reset();
  if (!standing.empty())
  {
    this->meshes_ = std::make_shared<const StandingMeshes>(
      std::make_shared<const Scene>(plan.revision, std::move(surfaces)), std::move(standing));
  }
}

bool MechanismBodies::knows(std::uint64_t plan) const noexcept
{
  return plan != 0 && (plan == this->plan_ || plan == this->before_);
}

void MechanismBodies::tell(const MechanismHand& told)
{
  this->told_ = told;
  if (told.plan != this->plan_)
  {
    this->told_.pose_W = this->begin_W_;
  }
  if (told.plan != this->plan_ && this->knows(told.plan))
  {
    this->told_.plan = this->plan_;
    this->told_.pose_W[static_cast<std::size_t>(this->held_)] = told.pose_W[static_cast<std::size_t>(this->held_)];
  }
  this->tellBodies();
}

void MechanismBodies::tellBodies()
{
  const MechanismHand& told = this->told_;
  for (std::size_t b = 0; b < this->hands_.size(); ++b)
  {
    BodyHand& hand = this->hands_[b];
    hand.tick = told.tick;
    hand.revision = this->given_[b] != nullptr ? this->given_[b]->revision : 0;
    hand.device_W = told.hand_W;
    hand.ball_W = told.tip_W;
    hand.count = 0;
    for (const MechanismPress& press : told.pressing())
    {
      if (press.soft == static_cast<int>(b) && hand.count < BodyHand::most)
      {
        hand.forceAt[hand.count] = press.at;
        hand.force_N[hand.count++] = press.force_N;
      }
    }
    this->lookAround(b, hand);
    // Points without a force now are answered as well: a constraint may press there in the next tick.
    for (std::size_t i = 0; i < this->places_[b].size() && hand.count < BodyHand::most; ++i)
    {
      hand.forceAt[hand.count] = this->places_[b][i];
      hand.force_N[hand.count++] = Vec3::Zero();
    }
  }
}

/// The snapshot answers where contacts were found, and around the middle of those of the mesh in the hand; where that
/// has none, around the mesh.
void MechanismBodies::lookAround(std::size_t body, BodyHand& hand) const
{
  if (!this->looks())
  {
    return;
  }
  const FoundContacts& found = this->finder_->last();
  Vec3 sum_W = Vec3::Zero();
  int count = 0; // of the mesh in the hand
  const auto answerAt = [&hand](const SurfacePoint& place)
  {
    const auto isThere = [&place](const SurfacePoint& at)
    { return at.vertices == place.vertices && at.weights == place.weights; };
    const bool isKnown = std::any_of(hand.forceAt.begin(), hand.forceAt.begin() + hand.count, isThere);
    if (!isKnown && hand.count < BodyHand::most)
    {
      hand.forceAt[hand.count] = place;
      hand.force_N[hand.count++] = Vec3::Zero();
    }
  };
  for (int i = 0; i < found.count; ++i)
  {
    const FoundContact& contact = found.contacts[static_cast<std::size_t>(i)];
    if (contact.body == this->finder_->bodyOf(body))
    {
      const bool isHeld = contact.mesh == this->held_;
      sum_W += isHeld ? contact.place_B.x_W : Vec3(Vec3::Zero());
      count += isHeld ? 1 : 0;
      answerAt(contact.place_B);
    }
    if (contact.mesh == this->finder_->bodyOf(body))
    {
      answerAt(contact.place_A);
    }
  }
  if (const SidedSurface* const mesh = this->finder_->held())
  {
    const SurfaceData& data = mesh->tree->data();
    const Pose& held_W = this->told_.pose_W[static_cast<std::size_t>(this->held_)];
    hand.ball_W = count > 0 ? Vec3(sum_W / count) : held_W * Vec3(0.5 * (data.low_W + data.high_W));
  }
  this->makers_[body]->watch(this->finder_->watched(body));
  this->makers_[body]->pressParts(this->finder_->parts(body));
  hand.tip_u = this->tips_u_[body] > 0.0 ? this->tips_u_[body] : this->finder_->tip_u(body);
}

/// Once the hand has told where the mesh is. Loose bodies have contacts before, or they would fall until then.
bool MechanismBodies::looks() const noexcept
{
  return this->finder_ && (this->told_.plan == this->plan_ || !this->loose_.empty());
}

void MechanismBodies::findAt(double time_s)
{
  constexpr double rounding_s = 1e-9; // of times that are sums of ticks
  if (!this->looks())
  {
    return;
  }
  if (this->underWay_.answer == 0)
  {
    this->underWay_ = this->find();
    this->due_s_ = time_s;
  }
  if (time_s >= this->due_s_ - rounding_s)
  {
    this->found_ = this->underWay_;
    this->underWay_ = this->find();
    this->due_s_ += this->period_s_;
  }
}

/// A loose body goes on as it went, is pushed by the hand, and falls, in the two periods until another answer is in
/// use: a t^2 / 2 with t two periods.
void MechanismBodies::reachLoose(double heldMotion_u)
{
  for (const Loose& loose : this->loose_)
  {
    const auto b = static_cast<std::size_t>(loose.body);
    const double motion_u =
      this->looked_W_ ? motionOf(loose.radius_u, (*this->looked_W_)[b], this->told_.pose_W[b]) : 0.0;
    this->looseReach_u_[b] = SidedSurface::looseReach * loose.diagonal_u + reachOfMotion * (motion_u + heldMotion_u) +
                             2.0 * loose.falls_u_per_s2 * this->period_s_ * this->period_s_;
  }
}

const FoundContacts& MechanismBodies::find()
{
  FinderView view;
  view.pose_W = this->told_.pose_W;
  const Pose& held_W = view.pose_W[static_cast<std::size_t>(this->held_)];
  const SidedSurface* const mesh = this->finder_->held();
  const double radius_u = mesh ? mesh->radius_u : this->rod_u_, diagonal_u = mesh ? mesh->diagonal_u : 0.0;
  const double motion_u =
    this->looked_W_ ? motionOf(radius_u, (*this->looked_W_)[static_cast<std::size_t>(this->held_)], held_W) : 0.0;
  // A mesh that is behind the hand comes after it.
  const double behind_u = std::min((this->told_.hand_W - held_W.p).norm(), usualReach * diagonal_u);
  view.held = { usualReach * diagonal_u + reachOfMotion * motion_u + behind_u,
    usualTouch * diagonal_u + touchOfMotion * motion_u, usualCover * diagonal_u + reachOfMotion * motion_u };
  // A soft body that the hand presses moves no faster than the hand.
  view.standing = { standingReach * this->diagonal_u_ + reachOfMotion * motion_u,
    standingTouch * this->diagonal_u_ + touchOfMotion * motion_u };
  view.soft = this->given_;
  view.presses = this->told_.pressing();
  this->reachLoose(motion_u);
  view.loose_u = this->looseReach_u_;
  this->looked_W_ = this->told_.pose_W;
  if (this->told_.plan != this->plan_)
  {
    view.held = { nowhere_u, nowhere_u, nowhere_u };
    this->looked_W_.reset();
  }
  const FoundContacts& found = this->finder_->find(view);
  this->tellBodies(); // snapshots that come with this answer have the compliance of its places
  return found;
}

void MechanismBodies::pace(double period_s)
{
  this->paced_.clear();
  this->period_s_ = period_s;
  for (const auto& maker : this->makers_)
  {
    this->paced_.emplace_back(*maker, period_s);
  }
}

std::span<const PressedBody* const> MechanismBodies::at(double time_s)
{
  this->findAt(time_s);
  for (std::size_t b = 0; b < this->paced_.size(); ++b)
  {
    (void)this->paced_[b].at(time_s, this->hands_[b]);
    this->newest_[b] = this->paced_[b].now() ? this->paced_[b].now() : this->newest_[b];
    this->given_[b] = this->newest_[b].get();
  }
  return this->given_;
}

bool MechanismBodies::pressEach(double period_s, int newtonSteps)
{
  bool all = true;
  this->found_ = this->looks() ? this->find() : this->found_;
  for (std::size_t b = 0; b < this->makers_.size(); ++b)
  {
    auto body = this->makers_[b]->press(this->hands_[b], period_s, newtonSteps);
    all = all && body;
    this->newest_[b] = body ? std::move(body) : this->newest_[b];
    this->given_[b] = this->newest_[b].get();
  }
  return all;
}

std::span<const PressedBody* const> MechanismBodies::rest(int newtonSteps)
{
  (void)this->pressEach(0.0, newtonSteps);
  return this->given_;
}

bool MechanismBodies::press(double period_s)
{
  return this->pressEach(period_s, BodyMaker::usualSteps);
}

std::vector<MechanismSoft> MechanismBodies::newestNamed() const
{
  std::vector<MechanismSoft> named = this->atRest_;
  for (std::size_t b = 0; b < named.size(); ++b)
  {
    named[b].body = this->newest_[b].get();
  }
  return named;
}

std::vector<SeenBody> MechanismBodies::seen() const
{
  std::vector<SeenBody> bodies;
  for (std::size_t b = 0; b < this->makers_.size(); ++b)
  {
    bodies.push_back({ this->asMade_[b], std::make_shared<const BodyShape>(this->makers_[b]->shape()) });
  }
  return bodies;
}

bool MechanismBodies::changed()
{
  const bool answered = !this->loose_.empty() && this->askedFound_ != this->found_.answer;
  const bool others = this->asked_ != this->newest_ || answered;
  this->asked_ = this->newest_;
  this->askedFound_ = this->found_.answer;
  return others;
}

} // namespace palpate
