// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/move/ToolMove.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "haptics/tool/move/SettledTarget.h"

namespace palpate
{
namespace
{

constexpr double provenGap = 0.5;    // of the rest gap; the other half allows for dips
constexpr double endOfMotion = 0.05; // of the rest gap
constexpr double leastMargin = 16.0; // rest gaps
constexpr double marginOfWay = 1.5;  // times the usual motion in an update
constexpr double roomLeft = 0.4;     // of the margin: with less left the pairs are gathered anew
constexpr int mostSteps = 60, mostRounds = 12, idleSteps = 2;
/// Most doublings of the work after updates that leave a tool where it is: a step in a close fit costs many times the
/// usual work before the first plane is searched, and a tool with less work would stand still for good.
constexpr int mostDoublings = 5;
constexpr double widestCircle = 16.0; // rest gaps: path length of steps in a circle that count as rest
constexpr double worthMoving = 0.25;  // of a step: with less the blocking rows are added first

/// Detects that a tool's steps lead back to an earlier pose: contacts that take turns may push it round for ever.
class Circle
{
public:
  Circle(const Pose& pose_W, double way_u, double reach_u) : reach_u_(reach_u) { this->remember(pose_W, way_u); }

  /// Length of the path back to the remembered pose; 0: it did not lead back. The pose that is remembered changes
  /// after twice as many steps each time, so that a circle of any length is found (Brent 1980).
  double close(const Pose& pose_W, double way_u)
  {
    constexpr double same = 0.01; // of the path length
    const double gone_u = way_u - this->way_u_;
    const double apart_u =
      (pose_W.p - this->pose_W_.p).norm() + turnFromTo(this->pose_W_.q, pose_W.q).norm() * this->reach_u_;
    if (apart_u <= same * gone_u)
    {
      return gone_u;
    }
    if (++this->steps_ == this->most_)
    {
      this->most_ *= 2;
      this->remember(pose_W, way_u);
    }
    return 0.0;
  }

private:
  void remember(const Pose& pose_W, double way_u)
  {
    this->pose_W_ = pose_W;
    this->way_u_ = way_u;
    this->steps_ = 0;
  }

  double reach_u_;
  Pose pose_W_;
  double way_u_ = 0.0;
  int steps_ = 0, most_ = 1;
};

} // namespace

ToolMove::ToolMove(const ToolMesh& tool, std::shared_ptr<const BoxedMesh> scene_W, double characteristic_u)
  : tool_(tool), scene_W_(std::move(scene_W)), characteristic_u_(characteristic_u), restGap_u_(tool.restGap_u()),
    near_(*tool.shape_B, *this->scene_W_), rows_(*tool.shape_B, *this->scene_W_, tool.restGap_u())
{
}

std::string ToolMove::place(const Pose& pose_W)
{
  const std::string refusal = refusePose(this->tool_, pose_W);
  if (!refusal.empty())
  {
    return refusal;
  }
  Pose unit_W = pose_W;
  unit_W.q.normalize();
  PairFront front(*this->tool_.shape_B, *this->scene_W_, this->restGap_u_);
  WorkBudget unlimited(std::numeric_limits<std::uint64_t>::max());
  static_cast<void>(front.gather(unit_W, leastMargin * this->restGap_u_, unlimited)); // the budget cannot run out
  this->near_.forget();
  this->near_.rebuild(front.near(), front.way_u(), front.margin_u());
  if (!standsFree(this->near_, unit_W, front.way_u(), provenGap * this->restGap_u_))
  {
    this->near_.forget();
    this->gathering_ = true; // the list is gathered anew for the pose of the tool
    return "the tool overlaps the scene at its start: start at a free position";
  }
  this->front_.emplace(std::move(front));
  this->pose_W_ = unit_W;
  this->gathering_ = false;
  this->behind_ = false;
  this->owed_ = 0;
  this->starved_ = 0;
  this->device_W_ = unit_W;
  this->usualWay_u_ = 0.0;
  this->rows_.findTouching(this->near_, this->pose_W_, this->front_->way_u());
  return {};
}

void ToolMove::stand(const Pose& pose_W)
{
  const double turn_rad = turnFromTo(this->pose_W_.q, pose_W.q).norm();
  this->front_->moved((pose_W.p - this->pose_W_.p).norm() + turn_rad * this->tool_.reach_u, turn_rad);
  this->pose_W_ = pose_W;
  this->rows_.findTouching(this->near_, this->pose_W_, this->front_->way_u());
}

bool ToolMove::makeScratch(WorkBudget& budget)
{
  if (!this->gathering_ && this->front_->room_u() > roomLeft * this->front_->margin_u())
  {
    return true;
  }
  this->gathering_ = !this->front_->gather(this->pose_W_, this->margin_u_, budget);
  if (!this->gathering_)
  {
    this->near_.rebuild(this->front_->near(), this->front_->way_u(), this->front_->margin_u());
    this->margin_u_ = (this->front_->near().empty() ? 2.0 : 1.0) * this->front_->margin_u();
  }
  return !this->gathering_;
}

ToolUpdate ToolMove::update(const Pose& device_W, std::uint64_t work)
{
  ToolUpdate done;
  done.refused = !refusePose(this->tool_, device_W).empty();
  if (done.refused)
  {
    return done;
  }
  const std::uint64_t granted = work << this->starved_;
  const std::uint64_t paid = std::min(granted, this->owed_);
  this->owed_ -= paid;
  WorkBudget budget(granted - paid);
  const Pose before_W = this->pose_W_;
  this->expect(device_W);
  this->idle_ = 0;
  Advance last = budget.left() > 0 ? Advance::Moved : Advance::Spent;
  Circle circle(this->pose_W_, this->front_->way_u(), this->tool_.reach_u);
  while (last == Advance::Moved && done.steps < mostSteps)
  {
    last = this->advance(device_W, budget);
    ++done.steps;
    // Poses within a few rest gaps, among which contacts take turns, are one position of rest.
    const double closed_u = circle.close(this->pose_W_, this->front_->way_u());
    const bool round = closed_u > endOfMotion * this->restGap_u_ && closed_u < widestCircle * this->restGap_u_;
    last = last == Advance::Moved && round ? Advance::Rests : last;
  }
  done.converged = last == Advance::Rests;
  done.blocked = last == Advance::Blocked;
  done.spent = last == Advance::Moved || last == Advance::Spent;
  done.leadCut = this->leadCut_;
  done.work = granted - budget.left();
  this->owed_ += budget.owed();
  this->behind_ = done.spent;
  const bool stands = this->pose_W_.p == before_W.p && this->pose_W_.q.coeffs() == before_W.q.coeffs();
  this->learnNeed(done, stands);
  return done;
}

/// Doubles the work of the next update where it was not enough for a step, and halves that again after one: a tool that
/// gets the usual work after each small step would stand still most of the time.
void ToolMove::learnNeed(const ToolUpdate& done, bool stands)
{
  if (!done.spent)
  {
    this->starved_ = 0;
  }
  else if (done.steps > 0 && !this->gathering_) // one that only pays or gathers tells nothing of a step
  {
    this->starved_ = std::clamp(this->starved_ + (stands ? 1 : -1), 0, mostDoublings);
  }
}

/// Sets how far the next list of near pairs has to reach: as far as the hand usually moves in an update. A tool that is
/// behind keeps its present margin, for it has further to go than the hand.
void ToolMove::expect(const Pose& device_W)
{
  constexpr double forgets = 0.8; // in an update
  const double turned_u = turnFromTo(this->device_W_.q, device_W.q).norm() * this->tool_.reach_u;
  const double way_u = (device_W.p - this->device_W_.p).norm() + turned_u;
  this->usualWay_u_ = std::max(way_u, forgets * this->usualWay_u_);
  this->device_W_ = device_W;
  const double usual_u = std::max(marginOfWay * this->usualWay_u_, leastMargin * this->restGap_u_);
  this->margin_u_ = this->behind_ ? std::max(usual_u, this->margin_u_) : usual_u;
}

/// Plans a step and proves it; a pair that blocks it early becomes a row, and the step is planned again.
ToolMove::ProvenStep ToolMove::planProven(const Vec6& wish, WorkBudget& budget)
{
  const StepLimits limits{ this->characteristic_u_, this->tool_.reach_u, this->restGap_u_, this->front_->room_u() };
  const double least_u = endOfMotion * this->restGap_u_;
  ProvenStep found;
  for (int round = 0; round < mostRounds; ++round)
  {
    budget.charge(work_price::plan + work_price::planOfRow * this->rows_.rows().size());
    found.planned = StepPlan(this->rows_.rows(), this->pose_W_, limits).plan(wish);
    const ScrewStep& step = found.planned.step;
    const double way_u = step.displacement_u(this->tool_.reach_u);
    found.rests = way_u < least_u;
    if (found.rests)
    {
      break;
    }
    const Clearance clearance{ provenGap * this->restGap_u_, least_u / way_u };
    found.verdict = proveStep(this->near_, { step, way_u, this->front_->way_u(), clearance }, budget);
    if (found.verdict.share > worthMoving || budget.left() == 0 ||
        !this->rows_.addBlocking(this->near_, step, found.verdict))
    {
      break;
    }
  }
  return found;
}

/// The device pose for which a tool without friction would move as this one does. `leadCut_` is about the hand
/// itself.
ToolMove::Lead ToolMove::lead(const Pose& device_W, WorkBudget& budget)
{
  Lead led{ device_W, wishedMotion(this->pose_W_, device_W, this->characteristic_u_, this->leadCut_) };
  if (this->friction_ > 0.0)
  {
    const ToolContacts set = this->contacts();
    const SettledTarget rubbed = settledTarget(set, led.wish, this->friction_);
    budget.charge(rubbed.rounds * std::uint64_t{ set.count });
    led.device_W = { this->pose_W_.p + rubbed.wish.head<3>(),
      (turnBy(rubbed.wish.tail<3>() / this->characteristic_u_) * this->pose_W_.q).normalized() };
    bool cut = false;
    led.wish = wishedMotion(this->pose_W_, led.device_W, this->characteristic_u_, cut);
  }
  return led;
}

ToolMove::Advance ToolMove::advance(const Pose& device_W, WorkBudget& budget)
{
  if (!this->makeScratch(budget))
  {
    return Advance::Spent;
  }
  this->rows_.findTouching(this->near_, this->pose_W_, this->front_->way_u());
  budget.charge(work_price::touching * this->rows_.asked());
  const Lead led = this->lead(device_W, budget);
  const ProvenStep found = this->planProven(led.wish, budget);
  if (found.rests)
  {
    return Advance::Rests;
  }
  const double share = found.verdict.share;
  if (share <= 0.0)
  {
    return budget.left() == 0 ? Advance::Spent : Advance::Blocked;
  }
  const ScrewStep taken{ this->pose_W_, share * found.planned.step.v_W, share * found.planned.step.w_W };
  this->commit(taken, this->usefulShare(found.planned, taken, led.device_W), share);
  if (this->idle_ >= idleSteps)
  {
    return Advance::Rests;
  }
  return budget.left() > 0 ? Advance::Moved : Advance::Spent;
}

/// The share of a proven step to take: where the sum of distance and pressed gaps is least on it, by the parabola
/// through its slope at the start and its value at the end. The whole step may overshoot where contacts curve.
double ToolMove::usefulShare(const PlannedStep& planned, const ScrewStep& step, const Pose& device_W)
{
  constexpr double nearlyAll = 0.75;
  const Pose end_W = step.end_W(1.0);
  const Mat3 turn = this->pose_W_.q.toRotationMatrix(), endTurn = end_W.q.toRotationMatrix();
  const double before = wishedDistance2(this->pose_W_, device_W, this->characteristic_u_);
  double change = wishedDistance2(end_W, device_W, this->characteristic_u_) - before;
  for (std::size_t i = 0; i < planned.pressures.size(); ++i)
  {
    if (planned.pressures[i] > 0.0)
    {
      const TouchFeature& feature = this->rows_.rows()[i].feature;
      change -= 2.0 * planned.pressures[i] *
                (planeAt(feature, endTurn, end_W.p).gap_u - planeAt(feature, turn, this->pose_W_.p).gap_u);
    }
  }
  const double slope = 2.0 * whitened(step.v_W, step.w_W, this->characteristic_u_).dot(planned.full);
  const double best = change + slope > 0.0 ? slope / (2.0 * (change + slope)) : 1.0;
  const double share = best > 0.0 && best < nearlyAll ? best : 1.0;
  const double taken = share * ((change + slope) * share - slope); // the parabola at the end of the step
  constexpr double rounding = 1e-14;
  this->idle_ = taken > -rounding * before ? this->idle_ + 1 : 0;
  return share;
}

ToolContacts ToolMove::contacts() const
{
  ToolContacts set;
  set.pose_W = this->pose_W_;
  set.characteristic_u = this->characteristic_u_;
  set.reach_u = this->tool_.reach_u;
  set.restGap_u = this->restGap_u_;
  set.placed = this->placed();
  std::vector<TouchPlane> planes;
  for (const TouchRow& row : this->rows())
  {
    planes.push_back(planeAt(row.feature, this->pose_W_.q.toRotationMatrix(), this->pose_W_.p));
  }
  std::stable_sort(
    planes.begin(), planes.end(), [](const TouchPlane& a, const TouchPlane& b) { return a.gap_u < b.gap_u; });
  set.count = static_cast<std::uint32_t>(std::min(planes.size(), ToolContacts::capacity));
  for (std::uint32_t i = 0; i < set.count; ++i)
  {
    set.contacts[i] = { planes[i].n_W, planes[i].arm_W, planes[i].gap_u };
  }
  return set;
}

void ToolMove::commit(const ScrewStep& step, double share, double proven)
{
  if (this->sink_ != nullptr)
  {
    this->sink_->step(step, share);
  }
  this->front_->moved(share * step.displacement_u(this->tool_.reach_u), share * step.w_W.norm());
  this->near_.made(proven * share, this->front_->way_u());
  this->pose_W_ = step.end_W(share);
}

} // namespace palpate
