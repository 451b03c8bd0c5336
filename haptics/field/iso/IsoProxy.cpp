// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/field/iso/IsoProxy.h"

#include <algorithm>
#include <cmath>

#include "haptics/field/iso/GridSpace.h"
#include "haptics/field/iso/IsoFriction.h"
#include "haptics/field/iso/IsoRows.h"
#include "haptics/field/iso/IsoSpace.h"
#include "haptics/field/iso/LevelMove.h"
#include "haptics/field/iso/TangentStep.h"

namespace palpate
{
namespace
{

constexpr double lessTrust = 0.3, moreTrust = 2.0; ///< factors
constexpr int mostFailures = 12, plainAfter = 2;
constexpr double rim = 0.5;          ///< [spacings]: a step that leaves the field by more is tried shorter
constexpr double beside = 1e-9;      ///< [spacings]: a place that is so near to a cell is in it but for its landing
constexpr double noProgress = 1e-15; ///< of the square of the distance, which a step changes by its own square
constexpr double liftedMore = 1.3;   ///< than a patch rises over a step: its third derivatives are not looked at
constexpr double leastLift = 2e-14;  ///< [spacings]: a few roundings of a place

/// One tick of a proxy.
class IsoMove
{
public:
  IsoMove(const IsoSpace& space, const IsoPlan& plan, IsoState& state, FieldPathSink* sink) noexcept
    : space_(space), of_{ state.level, state.side }, least_u_(space.least_u(state.x)),
      rounded_u_(space.rounded_u(state.x)), plan_(plan), state_(state), sink_(sink)
  {
  }

  IsoResult run(double arc_u) noexcept
  {
    this->arc_u_ = arc_u;
    this->trust_u_ = this->space_.firstStep_u(this->state_.x);
    bool more = true;
    while (more && this->result_.passes < this->plan_.passCap)
    {
      ++this->result_.passes;
      more = this->pass();
    }
    this->result_.capped = more && !this->result_.released;
    return this->result_;
  }
  /// True if the sweep was cut before the proxy was where it belongs.
  [[nodiscard]] bool cut() const noexcept { return this->cut_; }

private:
  /// One step of the proxy; false when it rests.
  bool pass() noexcept
  {
    const IsoView view{ this->space_, this->of_, this->state_.x, this->space_.toDrawn_u(this->state_.x),
      this->newestHit_ };
    IsoRows rows = rowsAt(view, { this->state_.cells.data(), static_cast<std::size_t>(this->state_.count) });
    const double slack_u = slackOf(view);
    const ProjectionResult y_u = projectOntoRows(rows, view.q_u, {}, slack_u);
    if (y_u.count == 0)
    {
      return this->goTowardsHand(view.q_u);
    }
    this->result_.normal = rows.row[rows.count - 1].n;
    Vec3 step_u = this->failures_ < plainAfter ? tangentStep(rows, y_u) : y_u.y;
    if (violates(rows, step_u, slack_u + 1e-12 * this->rounded_u_))
    {
      step_u = y_u.y;
    }
    if (!(step_u.squaredNorm() > noProgress * view.q_u.squaredNorm()))
    {
      return this->forgetFarCells(rows, y_u);
    }
    const double longest_u = std::min(this->trust_u_, this->arc_u_), length_u = step_u.norm();
    if (length_u > longest_u)
    {
      step_u *= longest_u / length_u;
    }
    return this->hop(view, rows, y_u, this->lifted(rows, step_u, slack_u));
  }

  [[nodiscard]] static bool violates(const IsoRows& rows, const Vec3& step_u, double slack_u) noexcept
  {
    return std::ranges::any_of(rows.all(), [&](const IsoRow& row) { return row.n.dot(step_u) < -row.gap_u - slack_u; });
  }

  /// No patch holds the proxy.
  bool goTowardsHand(const Vec3& q_u) noexcept
  {
    this->state_.count = 0;
    this->newestHit_ = false;
    const GridPlace from = this->state_.x;
    FieldSweepResult swept;
    const bool whole = this->sweep(from, q_u, this->arc_u_, swept);
    this->commit(from, swept.place);
    if (swept.end == SweepEnd::Left)
    {
      this->result_.released = true;
      return false;
    }
    if (swept.end == SweepEnd::Reached)
    {
      this->cut_ = !whole;
      return false;
    }
    this->add(swept.met);
    return this->arcLeft();
  }

  /// At rest, unless a patch holds the proxy from outside its cell.
  bool forgetFarCells(const IsoRows& rows, const ProjectionResult& y_u) noexcept
  {
    this->keep(rows, y_u);
    for (int i = 0; i < y_u.count; ++i)
    {
      const Vec3& t = rows.row[y_u.active[i]].t;
      const double out = std::max((-t).maxCoeff(), (t - Vec3::Ones()).maxCoeff());
      if (out > beside && y_u.lambda[i] > 0.0)
      {
        this->drop(rows.row[y_u.active[i]].cell);
        return true;
      }
    }
    return false;
  }

  /// The step with each patch passed above its rise along the step.
  [[nodiscard]] Vec3 lifted(IsoRows& rows, const Vec3& step_u, double slack_u) const noexcept
  {
    std::array<double, IsoState::mostCells> lift_u{};
    for (int i = 0; i < rows.count; ++i)
    {
      lift_u[i] = liftedMore * rows.row[i].rise_u(step_u) + leastLift * this->rounded_u_ + rows.row[i].margin_u;
    }
    return projectOntoRows(rows, step_u, { lift_u.data(), static_cast<std::size_t>(rows.count) }, slack_u).y;
  }

  /// Over the patches and down towards the hand; both moves are made only if that comes nearer.
  bool hop(const IsoView& view, const IsoRows& rows, const ProjectionResult& y_u, const Vec3& step_u) noexcept
  {
    const GridPlace from = this->state_.x;
    const double before_u2 = view.q_u.squaredNorm();
    FieldSweepResult first;
    (void)this->sweep(from, step_u, this->arc_u_, first);
    if (first.end == SweepEnd::Left)
    {
      return step_u.norm() > rim * this->least_u_ ? this->fail(rows, y_u) : this->leave(from, first);
    }
    if (first.end == SweepEnd::Hit)
    {
      return this->stopAtHit(from, first, rows, y_u, before_u2);
    }
    FieldSweepResult second;
    const Vec3 down_u = this->space_.toDrawn_u(first.place);
    const double left_u = this->arc_u_ - this->space_.between_u(from, first.place).norm();
    (void)this->sweep(first.place, down_u, left_u, second);
    if (!(this->distance2(second.place) < before_u2))
    {
      return this->fail(rows, y_u);
    }
    this->commit(from, first.place);
    this->commit(first.place, second.place);
    this->keep(rows, y_u);
    if (second.end == SweepEnd::Left)
    {
      this->result_.released = true;
      return false;
    }
    this->newestHit_ = false;
    if (second.end == SweepEnd::Hit)
    {
      this->add(second.met);
    }
    this->trust_u_ *= moreTrust;
    this->failures_ = 0;
    return this->arcLeft();
  }

  bool leave(const GridPlace& from, const FieldSweepResult& swept) noexcept
  {
    this->commit(from, swept.place);
    this->result_.released = true;
    return false;
  }

  bool stopAtHit(const GridPlace& from, const FieldSweepResult& first, const IsoRows& rows, const ProjectionResult& y_u,
    double before_u2) noexcept
  {
    const bool known = std::ranges::any_of(rows.all(), [&](const IsoRow& row) { return row.cell == first.met; });
    const bool nearer = this->distance2(first.place) < before_u2;
    this->keep(rows, y_u);
    this->add(first.met);
    this->newestHit_ = nearer;
    if (nearer)
    {
      this->commit(from, first.place);
    }
    if (known || !nearer)
    {
      return this->shrink();
    }
    this->failures_ = 0;
    return this->arcLeft();
  }

  bool fail(const IsoRows& rows, const ProjectionResult& y_u) noexcept
  {
    this->keep(rows, y_u);
    return this->shrink();
  }

  bool shrink() noexcept
  {
    this->trust_u_ *= lessTrust;
    return ++this->failures_ <= mostFailures && this->arcLeft();
  }

  [[nodiscard]] double distance2(const GridPlace& place) const noexcept
  {
    return this->space_.toDrawn_u(place).squaredNorm();
  }

  /// False where there is not enough arc for the whole displacement.
  bool sweep(const GridPlace& from, const Vec3& way_u, double most_u, FieldSweepResult& swept) noexcept
  {
    const double length_u = way_u.norm();
    const bool whole = length_u <= most_u;
    const Vec3 gone_u = whole ? way_u : Vec3(way_u * (most_u / length_u));
    swept = this->space_.sweep(this->of_, from, gone_u);
    ++this->result_.sweeps;
    this->result_.cells += swept.cells;
    return whole;
  }

  void commit(const GridPlace& from, const GridPlace& to) noexcept
  {
    this->arc_u_ -= this->space_.between_u(from, to).norm();
    this->state_.x = to;
    if (this->sink_ != nullptr)
    {
      this->sink_->piece(from, to, this->state_.level, this->state_.side);
    }
  }

  bool arcLeft() noexcept
  {
    this->cut_ = !(this->arc_u_ > 1e-12 * this->least_u_);
    return !this->cut_;
  }

  /// The patches that push, in their order.
  void keep(const IsoRows& rows, const ProjectionResult& y_u) noexcept
  {
    this->state_.count = 0;
    for (int i = 0; i < rows.count; ++i)
    {
      const auto* const end = y_u.active.data() + y_u.count;
      if (std::find(y_u.active.data(), end, i) != end)
      {
        this->state_.cells[this->state_.count++] = rows.row[i].cell;
      }
    }
  }

  void add(const GridIndex& cell) noexcept
  {
    this->drop(cell);
    if (this->state_.count == IsoState::mostCells)
    {
      this->drop(this->state_.cells[0]);
    }
    this->state_.cells[this->state_.count++] = cell;
    this->newestHit_ = true;
  }

  void drop(const GridIndex& cell) noexcept
  {
    auto* const begin = this->state_.cells.data();
    this->state_.count = static_cast<int>(std::remove(begin, begin + this->state_.count, cell) - begin);
  }

  const IsoSpace& space_;
  IsoSide of_;
  double least_u_;   ///< least width of the cell in which the tick begins
  double rounded_u_; ///< scale of the rounding of a place
  const IsoPlan& plan_;
  IsoState& state_;
  FieldPathSink* sink_;
  IsoResult result_;
  double arc_u_ = 0.0;   ///< that may still be gone
  double trust_u_ = 0.0; ///< longest step
  int failures_ = 0;     ///< since a step came nearer
  bool newestHit_ = false;
  bool cut_ = false;
};

/// A hand that nothing is known of is on the side where it is; none where there is no value.
void latch(const IsoSpace& space, const IsoPlan& plan, const Vec3& shift_u, IsoState& state) noexcept
{
  state = IsoState{};
  const std::optional<GridPlace> hand = space.besideHand(shift_u);
  const std::optional<GridPlace> place = hand ? space.within(*hand) : std::nullopt;
  state.x = state.device = hand.value_or(GridPlace());
  state.level = plan.level;
  const double above = place ? space.cell(place->cell, { plan.level, 1.0 }).value(place->t) : std::nan("");
  state.side = above < 0.0 ? -1.0 : 1.0;
  state.placed = above == above;
}

/// The hand goes through a surface that holds less than its push: the proxy trails by the force at which the surface
/// yields.
void yield(const IsoSpace& space, const IsoPlan& plan, IsoState& state, IsoResult& result) noexcept
{
  const double far_u = result.pull_u.norm();
  if (far_u > plan.yield_u)
  {
    result.pull_u *= plan.yield_u / far_u;
    latch(space, plan, result.pull_u, state);
    space.remember(state);
    result.yielded = true;
  }
}

} // namespace

bool IsoSpace::isFree(const IsoSide& of, const GridPlace& at) const noexcept
{
  const std::optional<GridPlace> place = this->within(at);
  if (!place)
  {
    return false;
  }
  const TrilinearCell cell = this->cell(place->cell, of);
  return cell.value(place->t) >= landingMargin(cell);
}

IsoResult moveIsoProxy(IsoSpace& space, const IsoPlan& plan, IsoState& state, FieldPathSink* sink) noexcept
{
  IsoResult result;
  if (!state.placed)
  {
    latch(space, plan, Vec3::Zero(), state);
    space.remember(state);
    return result;
  }
  const double way_u = space.handWay_u(state);
  space.remember(state);
  if (!moveLevel(space, plan, state, sink))
  {
    result.released = true;
    state = IsoState{};
    return result;
  }
  const IsoFriction friction = judgeIsoFriction(space, plan.friction, space.toHand_u(state.x), state);
  const bool limited = state.catchingUp && plan.scrub_u > 0.0;
  if (!friction.sticks)
  {
    if (state.slips)
    {
      space.draw(friction.shift_u);
    }
    IsoMove move(space, plan, state, sink);
    result = move.run(limited ? way_u + plan.scrub_u : std::numeric_limits<double>::infinity());
    state.catchingUp = limited && (move.cut() || state.level != plan.level);
  }
  const double left = 1.0 - static_cast<double>(state.stuck) / IsoState::mostStuck;
  result.pull_u = left * space.fromHand_u(state.x);
  result.contacts = state.count;
  if (result.released)
  {
    result.pull_u = Vec3::Zero();
    state = IsoState{};
  }
  else
  {
    yield(space, plan, state, result);
  }
  return result;
}

IsoResult moveIsoProxy(const FieldBlockComponent& field, const Vec3& spacing_u, const IsoPlan& plan, const Vec3& device,
  IsoState& state, FieldPathSink* sink) noexcept
{
  GridSpace space(field, spacing_u, device);
  return moveIsoProxy(space, plan, state, sink);
}

} // namespace palpate
