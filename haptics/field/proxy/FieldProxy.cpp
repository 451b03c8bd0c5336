// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/field/proxy/FieldProxy.h"

#include <algorithm>
#include <cmath>

#include "haptics/field/iso/CellSpace.h"
#include "haptics/field/iso/GridSpace.h"
#include "haptics/field/laws/Follow.h"
#include "haptics/field/laws/Primitives.h"

namespace palpate
{
namespace
{

/// How far an isosurface may move under the hand in a tick, times the stiffness: no step of a tenth of a newton.
constexpr double scrub_N = 0.045;

bool usesSoft(const FieldBlock& brick, const FieldPlan& plan) noexcept
{
  const bool directions =
    brick.component(FieldBlockRole::Vector).exists() || brick.component(FieldBlockRole::Axis).exists();
  return plan.drag_N > 0.0 || (plan.follow_N > 0.0 && directions) ||
         (plan.snap_N > 0.0 && !(brick.places_W().empty() && brick.lines_W().empty())) ||
         (plan.compare_N > 0.0 && brick.component(FieldBlockRole::Other).exists());
}

bool usesScalar(const FieldBlock& brick, bool on) noexcept
{
  return on && brick.component(FieldBlockRole::Scalar).exists();
}

/// How much of a strength there is at a value: nothing at `none` and beyond, all at `full` and beyond, whichever of
/// both is larger; where they are the same all of it.
double share(double value, double none, double full) noexcept
{
  return full != none ? std::max(0.0, std::min(1.0, (value - none) / (full - none))) : 1.0;
}

/// The parts of a block that are felt in a tick.
struct FeltPart
{
  const FieldBlock& whole; ///< of smooth levels: its lattice is that of all blocks of the data
  const FieldBlock& brick; ///< of all other forces
  const FieldCells* cells; ///< of surfaces; null: they are the block's

  [[nodiscard]] std::uint64_t contentHash() const noexcept
  {
    return this->cells != nullptr ? this->cells->contentHash() : this->brick.contentHash();
  }
};

/// One tick of a hand in a field.
class FieldTick
{
public:
  FieldTick(const FeltPart& felt, const FieldPlan& plan, double stiffness, const Vec3& p_W, FieldState& state) noexcept
    : whole_(felt.whole), brick_(felt.brick), cells_(felt.cells), plan_(plan), k_(stiffness), p_W_(p_W), state_(state)
  {
  }

  FieldResult run() noexcept
  {
    const bool covered = this->hasValue();
    const bool detent = usesScalar(this->brick_, this->plan_.detent.strength_N > 0.0);
    const bool surface =
      this->mayBeHeld(covered, usesScalar(this->brick_, this->plan_.isosurface), this->state_.surface);
    const bool click = this->mayBeHeld(covered, detent && this->plan_.detent.click, this->state_.click);
    const bool smooth = covered && detent && !this->plan_.detent.click;
    const bool soft = covered && usesSoft(this->brick_, this->plan_);
    this->result_.outside = !covered;
    this->result_.beyond = !(this->brick_.grid().roomAt_u(this->p_W_) >= 0.0);
    this->forgetUnless(surface, this->state_.surface);
    this->forgetUnless(click, this->state_.click);
    if (surface)
    {
      this->surface();
    }
    if (click)
    {
      this->click();
    }
    this->state_.detent_W = smooth && this->state_.placed ? this->state_.detent_W : this->p_W_;
    if (smooth)
    {
      this->smooth();
    }
    this->state_.soft_W = soft && this->state_.placed ? this->state_.soft_W : this->p_W_;
    if (soft)
    {
      this->soft();
    }
    this->push();
    const bool onlyHeld = (this->state_.surface.placed || this->state_.click.placed) &&
                          !usesSoft(this->brick_, this->plan_) && !(detent && !this->plan_.detent.click);
    this->result_.letGo = this->result_.letGo || (this->state_.placed && !covered && !onlyHeld);
    this->state_.placed = covered;
    return this->result_;
  }

private:
  /// Where the first array has none the hand is outside of the field.
  [[nodiscard]] bool hasValue() const noexcept
  {
    if (this->cells_ != nullptr)
    {
      return this->cells_->locate(this->p_W_).has_value();
    }
    const bool any = !this->brick_.arrays().empty();
    return any && this->brick_.sample(this->brick_.arrays().front().role, this->p_W_).has_value();
  }

  /// Where there is no value a surface that was there before may be between the hand and its proxy.
  static bool mayBeHeld(bool covered, bool used, const IsoState& state) noexcept
  {
    return used && (covered || state.placed);
  }

  static void forgetUnless(bool used, IsoState& state) noexcept
  {
    if (!used)
    {
      state = IsoState{};
    }
  }

  void add(const Vec3& pull_W) noexcept
  {
    this->result_.pull_W += pull_W;
    this->result_.stretch2_u2 += pull_W.squaredNorm();
  }

  void addIso(const IsoPlan& plan, IsoState& state) noexcept
  {
    const IsoResult iso = this->moveIso(plan, state);
    this->result_.contacts += iso.contacts > 0 ? 1 : 0;
    this->result_.passes += iso.passes;
    this->result_.letGo = this->result_.letGo || iso.released;
    this->result_.capped = this->result_.capped || iso.capped;
  }

  IsoResult moveIso(const IsoPlan& plan, IsoState& state) noexcept
  {
    if (this->cells_ != nullptr)
    {
      CellSpace space(*this->cells_, this->p_W_);
      const IsoResult iso = moveIsoProxy(space, plan, state);
      state.x_W = state.placed ? this->cells_->toWorld(state.x) : this->p_W_;
      this->add(iso.pull_u);
      return iso;
    }
    const FieldBlockGrid& grid = this->brick_.grid();
    const IsoResult iso = moveIsoProxy(
      this->brick_.component(FieldBlockRole::Scalar), grid.spacing_u, plan, grid.toIndex(this->p_W_), state);
    this->add(grid.pose_W.q * iso.pull_u);
    return iso;
  }

  [[nodiscard]] Vec3 placeOf_W(const IsoState& state) const noexcept
  {
    return this->cells_ != nullptr ? state.x_W : this->brick_.grid().toWorld(state.x.index());
  }

  [[nodiscard]] std::optional<double> scalarAt(const Vec3& p_W) const noexcept
  {
    if (this->cells_ != nullptr)
    {
      const std::optional<GridPlace> place = this->cells_->locate(p_W);
      return place ? std::optional(this->cells_->cell(place->cell).value(place->t)) : std::nullopt;
    }
    const std::optional<FieldSample> sample = this->brick_.sample(FieldBlockRole::Scalar, p_W);
    return sample ? std::optional(sample->value) : std::nullopt;
  }

  void surface() noexcept
  {
    IsoPlan plan;
    plan.level = this->plan_.isovalue;
    plan.friction = this->plan_.friction;
    plan.scrub_u = scrub_N / this->k_;
    plan.yield_u = this->plan_.yield_N > 0.0 ? this->plan_.yield_N / this->k_ : plan.yield_u;
    this->addIso(plan, this->state_.surface);
    this->result_.surface_W = this->placeOf_W(this->state_.surface);
  }

  /// The level before the hand is a membrane; the proxy stands between two of them.
  void click() noexcept
  {
    IsoState& state = this->state_.click;
    IsoPlan plan;
    plan.yield_u = this->plan_.detent.strength_N / this->k_;
    const std::optional<double> hand = this->scalarAt(this->p_W_);
    const std::optional<double> proxy = this->scalarAt(state.placed ? this->placeOf_W(state) : this->p_W_);
    plan.level = state.level;
    const bool pressed = hand && state.count > 0 && state.side * (*hand - state.level) < 0.0;
    if (hand && proxy && !pressed)
    {
      const bool above = *hand > *proxy;
      plan.level = state.level = nextLevel(this->plan_.detent, *proxy, above);
      state.side = above ? -1.0 : 1.0;
      state.count = 0;
    }
    this->addIso(plan, state);
  }

  void smooth() noexcept
  {
    DetentPlan detent = this->plan_.detent;
    detent.strength_N = std::min(detent.strength_N, mostSmooth_N(detent, this->k_));
    this->state_.detent_W = smoothDetent(this->whole_, detent, this->k_, this->p_W_, this->state_.detent_W);
    this->add(this->state_.detent_W - this->p_W_);
  }

  /// All pulls of limited strength are one problem with one answer.
  void soft() noexcept
  {
    std::array<Primitive, 4> primitives;
    std::size_t count = 0;
    const auto give = [&](const Primitive& primitive)
    {
      if (primitive.strength_N > 0.0)
      {
        primitives[count++] = primitive;
      }
    };
    give({ PrimitiveKind::Point, this->drag_N(), this->state_.soft_W });
    give({ PrimitiveKind::Point, this->compare_N(), this->state_.soft_W });
    if (const std::optional<Followed> line = this->followed())
    {
      const double strength_N = this->plan_.follow_N * share(line->speed, this->plan_.noSpeed, this->plan_.fullSpeed);
      give({ PrimitiveKind::Line, strength_N, line->y_W, line->along_W });
    }
    give(this->snap());
    const PrimitiveSolution solution = solvePrimitives({ primitives.data(), count }, this->p_W_, this->k_);
    this->state_.soft_W = solution.x;
    this->result_.error_u = solution.error_u;
    this->add(solution.x - this->p_W_);
  }

  [[nodiscard]] double drag_N() const noexcept
  {
    if (!this->brick_.component(FieldBlockRole::Resistance).exists())
    {
      return this->plan_.drag_N;
    }
    const std::optional<FieldSample> resistance = this->brick_.sample(FieldBlockRole::Resistance, this->p_W_);
    return resistance ? this->plan_.drag_N * share(resistance->value, this->plan_.dragNone, this->plan_.dragFull) : 0.0;
  }

  [[nodiscard]] double compare_N() const noexcept
  {
    const std::optional<FieldSample> one = this->brick_.sample(FieldBlockRole::Scalar, this->p_W_);
    const std::optional<FieldSample> other = this->brick_.sample(FieldBlockRole::Other, this->p_W_);
    return one && other
             ? this->plan_.compare_N * share(std::fabs(one->value - other->value), 0.0, this->plan_.compareFull)
             : 0.0;
  }

  [[nodiscard]] std::optional<Followed> followed() const noexcept
  {
    return this->plan_.follow_N > 0.0 ? followStreamline(this->brick_, this->state_.soft_W, this->p_W_) : std::nullopt;
  }

  /// The strength depends on the hand's distance alone, so it has a potential.
  [[nodiscard]] Primitive snap() const noexcept
  {
    Primitive snap;
    if (const auto place_W = this->brick_.nearestPlace_W(this->p_W_, this->plan_.snapReach_u))
    {
      snap.anchor = *place_W;
      snap.strength_N = this->plan_.snap_N * (1.0 - (*place_W - this->p_W_).norm() / this->plan_.snapReach_u);
    }
    return snap;
  }

  void push() noexcept
  {
    const std::optional<Vec3> v_W = this->plan_.push_N > 0.0 ? this->brick_.vector(this->p_W_) : std::nullopt;
    const double speed = v_W ? v_W->norm() : 0.0;
    if (speed > 0.0)
    {
      this->result_.push_W =
        this->plan_.push_N * share(speed, this->plan_.noSpeed, this->plan_.fullSpeed) / speed * *v_W;
    }
  }

  const FieldBlock& whole_;
  const FieldBlock& brick_;
  const FieldCells* cells_;
  const FieldPlan& plan_;
  double k_;
  const Vec3& p_W_;
  FieldState& state_;
  FieldResult result_;
};

/// The same place in another grid. Grids whose points fall together keep every bit of it.
GridPlace placeIn(const FieldBlockGrid& now, const FieldBlockGrid& was, const GridPlace& x) noexcept
{
  const Vec3 shift = now.toIndex(was.pose_W.p);
  GridPlace place = x;
  bool aligned = now.spacing_u == was.spacing_u && now.pose_W.q.coeffs() == was.pose_W.q.coeffs();
  for (int k = 0; k < 3; ++k)
  {
    const double whole = std::floor(shift[k] + 0.5);
    constexpr double rounding = 1e-9; // of a spacing
    aligned = aligned && std::fabs(shift[k] - whole) < rounding && std::fabs(whole) < 1e9;
    place.cell[k] += aligned ? static_cast<int>(whole) : 0;
  }
  return aligned ? place : GridPlace::at(now.toIndex(was.toWorld(x.index())));
}

/// A proxy stands where it stood, or there is no value there. Where the surface is not where it was, it goes from the
/// proxy to its own place as if its value were changed: on the same side, and no faster.
void keepSide(const IsoSpace& space, IsoState& state) noexcept
{
  state.catchingUp = state.count > 0;
  state.count = 0;
  const IsoSide of{ state.level, state.side };
  const std::optional<GridPlace> place = space.within(state.x);
  const TrilinearCell cell = place ? space.cell(place->cell, of) : TrilinearCell{ { NAN } };
  if (!cell.valid())
  {
    state = IsoState{};
    return;
  }
  constexpr double above = 1e-13; // of the largest corner: more than a landing keeps
  const double value = cell.value(place->t), least = above * cell.largestMagnitude();
  state.level += value < least ? state.side * (value - least) : 0.0;
}

bool isOfCells(const FieldState& state) noexcept
{
  return state.grid.size[0] == 0;
}

/// A proxy in another part of the data stays where it is.
void carryIso(const FeltPart& felt, const FieldState& was, IsoState& state) noexcept
{
  if (!state.placed || !felt.brick.component(FieldBlockRole::Scalar).exists())
  {
    state = IsoState{};
    return;
  }
  const bool ofCells = isOfCells(was);
  const Vec3 x_W = ofCells ? state.x_W : was.grid.toWorld(state.x.index());
  const Vec3 device_W = ofCells ? state.device.t : was.grid.toWorld(state.device.index());
  if (felt.cells != nullptr)
  {
    const std::optional<GridPlace> place = felt.cells->locate(x_W);
    state.x = place.value_or(GridPlace{ { -1, 0, 0 } });
    state.device = { {}, device_W };
    state.x_W = x_W;
    keepSide(CellSpace(*felt.cells, device_W), state);
    return;
  }
  const FieldBlockGrid& grid = felt.brick.grid();
  state.x = ofCells ? GridPlace::at(grid.toIndex(x_W)) : placeIn(grid, was.grid, state.x);
  state.device = ofCells ? GridPlace::at(grid.toIndex(device_W)) : placeIn(grid, was.grid, state.device);
  keepSide(GridSpace(felt.brick.component(FieldBlockRole::Scalar), grid.spacing_u, state.device.index()), state);
}

/// How far the proxy that is furthest from a hand is away [u].
double furthestProxy_u(const FieldState& state, const Vec3& p_W) noexcept
{
  double square_u2 = state.placed ? (state.soft_W - p_W).squaredNorm() : 0.0;
  square_u2 = state.placed ? std::max(square_u2, (state.detent_W - p_W).squaredNorm()) : square_u2;
  for (const IsoState* iso : { &state.surface, &state.click })
  {
    const Vec3 x_W = isOfCells(state) ? iso->x_W : state.grid.toWorld(iso->x.index());
    square_u2 = std::max(square_u2, iso->placed ? (x_W - p_W).squaredNorm() : 0.0);
  }
  return std::sqrt(square_u2);
}

/// The finer block where it holds the ball around the hand that all proxies are in: none of them leaves that ball in a
/// tick, so none meets the rim. Taken up an eighth of its width inside, so that a hand at the rim is not handed to and
/// fro.
const FieldBlock& feltFieldBlock(const FieldBlock& brick, const Vec3& p_W, const FieldState& state) noexcept
{
  const FieldBlock* const finer = brick.finer().get();
  if (finer == nullptr)
  {
    return brick;
  }
  const FieldBlockGrid& grid = finer->grid();
  const Vec3 last(grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1);
  const double width_u = last.cwiseProduct(grid.spacing_u).minCoeff();
  const bool isFelt = state.brick == finer->contentHash();
  const double margin_u = isFelt ? 2.0 * grid.spacing_u.maxCoeff() : 0.125 * width_u;
  return grid.roomAt_u(p_W) >= furthestProxy_u(state, p_W) + margin_u ? *finer : brick;
}

/// The data's own cells by the same rule; where they are all of the data's they are felt everywhere.
const FieldCells* feltCells(const FieldBlock& brick, const Vec3& p_W, const FieldState& state) noexcept
{
  const FieldCells* const cells = brick.cells().get();
  constexpr double takenUp = 0.25, left = 0.02; // of the displacement that they reach
  const double share = cells != nullptr && state.brick == cells->contentHash() ? left : takenUp;
  const bool reaches =
    cells != nullptr && (std::isinf(cells->parts().reach_u) ||
                          cells->roomAt_u(p_W) >= furthestProxy_u(state, p_W) + share * cells->parts().reach_u);
  return reaches ? cells : nullptr;
}

} // namespace

int springsOf(const FieldBlock& brick, const FieldPlan& plan) noexcept
{
  return static_cast<int>(usesScalar(brick, plan.isosurface)) +
         static_cast<int>(usesScalar(brick, plan.detent.strength_N > 0.0)) + static_cast<int>(usesSoft(brick, plan));
}

FieldResult moveFieldProxy(
  const FieldBlock& whole, const FieldPlan& plan, double stiffness_N_per_u, const Vec3& p_W, FieldState& state) noexcept
{
  const FeltPart felt{ whole, feltFieldBlock(whole, p_W, state), feltCells(whole, p_W, state) };
  if (state.brick != felt.contentHash())
  {
    if (state.brick != 0)
    {
      carryIso(felt, state, state.surface);
      carryIso(felt, state, state.click);
    }
    state.brick = felt.contentHash();
    state.grid = felt.cells != nullptr ? FieldBlockGrid{} : felt.brick.grid();
  }
  return FieldTick(felt, plan, stiffness_N_per_u, p_W, state).run();
}

} // namespace palpate
