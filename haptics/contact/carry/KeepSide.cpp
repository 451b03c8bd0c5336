// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/carry/KeepSide.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "haptics/contact/GodObject.h"
#include "haptics/contact/carry/Deformation.h"
#include "haptics/contact/sweep/Sweep.h"
#include "haptics/contact/view/Resolution.h"
#include "haptics/geometry/mesh/NearestOnTriangle.h"
#include "haptics/geometry/tree/SurfaceData.h"

namespace palpate
{
namespace
{

/// The surface, simpler or full, that has taken the place of one that is gone; null where none has.
const Surface* exchangedFor(
  const std::vector<Surface>& before, std::uint32_t i, const std::vector<Surface>& after) noexcept
{
  const Surface& old = before[i];
  const auto stands = [&old](const Surface& s)
  { return (old.standsFor.full != 0 || s.standsFor.full != 0) && fullContentOf(s) == fullContentOf(old); };
  const auto found = std::find_if(after.begin(), after.end(), stands);
  return found != after.end() && successorOf(before, i, after) == after.size() ? &*found : nullptr;
}

/// Two surfaces near the ball: one has taken the other's place.
struct Exchange
{
  const SurfaceData* old = nullptr;
  const SurfaceData* coarser = nullptr;
  double bound_u = 0.0;
};

/// A point of a surface.
struct Foot
{
  Vec3 at_W, normal_W; ///< of curves, no normal
};

std::optional<Foot> footOn(
  const SurfaceData& surface, const Vec3& x_W, double reach_u, const ContactPlan& plan) noexcept
{
  const std::optional<std::uint32_t> nearest = nearestTriangle(surface, x_W, reach_u, plan.workBudget);
  if (!nearest)
  {
    return std::nullopt;
  }
  const FaceRecord& face = surface.face(*nearest);
  const auto& [a, b, c] = face.corner_W;
  return Foot{ nearestOnTriangle(x_W, a, b, c), surface.coat_u > 0.0 ? Vec3(Vec3::Zero()) : face.normal_W };
}

template<SceneView AnyScene>
class SideKeeper
{
public:
  SideKeeper(const AnyScene& from, const AnyScene& to, const ContactPlan& plan, const Vec3& x_W) noexcept
    : from_(from), to_(to), plan_(plan), x_W_(x_W), best_W_(x_W)
  {
    this->resolution_.include(x_W);
  }

  [[nodiscard]] std::optional<Vec3> run(const Vec3& p_W) noexcept
  {
    const std::vector<Surface>&before = sceneOf(this->from_).surfaces(), &after = sceneOf(this->to_).surfaces();
    for (std::uint32_t i = 0; i < before.size() && this->count_ < this->near_.size(); ++i)
    {
      if (const Surface* const now = exchangedFor(before, i, after))
      {
        this->look(before[i], *now);
      }
    }
    if (this->count_ == 0)
    {
      return std::nullopt;
    }
    this->best_u_ = this->clearOf(this->x_W_);
    this->tryAll(p_W);
    if (this->best_u_ <= this->tolerance_u_)
    {
      this->slides_ = true;
      this->tryAll(p_W);
    }
    return stopBefore(this->to_, this->plan_, this->plan_.radius_u, this->best_W_, this->x_W_);
  }

private:
  static constexpr std::size_t mostNear = 4; ///< surfaces that are exchanged near the ball: bounds the work of a swap

  [[nodiscard]] std::span<const Exchange> exchanges() const noexcept { return { this->near_.data(), this->count_ }; }

  void look(const Surface& was, const Surface& is) noexcept
  {
    const bool wasCoarser = was.standsFor.bound_u > is.standsFor.bound_u;
    const SurfaceData &old = was.tree->data(), &coarser = wasCoarser ? old : is.tree->data();
    const Exchange exchange{ &old, &coarser, was.standsFor.bound_u + is.standsFor.bound_u };
    const double touches_u = this->plan_.radius_u + coarser.coat_u + 4 * this->resolution_.tol();
    const std::optional<Foot> foot = footOn(coarser, this->x_W_, exchange.bound_u + touches_u, this->plan_);
    if (foot && (this->x_W_ - foot->at_W).norm() <= exchange.bound_u + touches_u)
    {
      this->near_[this->count_++] = exchange;
      // From as far on the other side as the old one may be to as far on this side, and as much again to spare.
      this->tolerance_u_ = std::max(this->tolerance_u_, exchange.bound_u + touches_u);
      this->way_u_ = std::max(this->way_u_, 4 * exchange.bound_u + touches_u);
    }
  }

  /// Least distance of all that is exchanged; no more than twice the way is looked for.
  [[nodiscard]] double clearOf(const Vec3& y_W) const noexcept
  {
    double least_u = 2 * this->way_u_;
    for (const Exchange& exchange : this->exchanges())
    {
      const std::optional<Foot> foot = footOn(*exchange.coarser, y_W, least_u, this->plan_);
      least_u = foot ? std::min(least_u, (y_W - foot->at_W).norm()) : least_u;
    }
    return least_u;
  }

  void tryAll(const Vec3& p_W) noexcept
  {
    for (const Exchange& exchange : this->exchanges())
    {
      this->tryAround(exchange);
    }
    this->tryTowards(this->x_W_ - p_W);
  }

  void tryAround(const Exchange& exchange) noexcept
  {
    for (const SurfaceData* const surface : { exchange.coarser, exchange.old })
    {
      const double reach_u = this->way_u_ + surface->coat_u;
      if (const std::optional<Foot> foot = footOn(*surface, this->x_W_, reach_u, this->plan_))
      {
        for (const Vec3& along_W : { foot->normal_W, Vec3(this->x_W_ - foot->at_W) })
        {
          this->tryTowards(along_W);
          this->tryTowards(-along_W);
        }
      }
    }
  }

  [[nodiscard]] Vec3 straight(const Vec3& way_W) const noexcept
  {
    const SweepHit hit = sweepStraight(this->from_, this->plan_, this->plan_.radius_u, this->x_W_, this->x_W_ + way_W);
    return this->x_W_ + (hit.hit ? 0.5 * hit.t : hit.freeUntil) * way_W;
  }

  /// Out of a pocket, as a hand would be drawn out of it.
  [[nodiscard]] Vec3 slid(const Vec3& way_W) const noexcept
  {
    constexpr int ticks = 4; // each goes on where the last one met its pass cap; a pocket that takes more is not left
    ContactPlan smooth = this->plan_;
    smooth.friction = {};
    smooth.shading = false;
    GodObjectState state;
    state.x_W = state.device_W = this->x_W_;
    state.placed = true;
    for (int tick = 0; tick < ticks; ++tick)
    {
      static_cast<void>(moveGodObject(this->from_, smooth, this->x_W_ + way_W, state));
    }
    return state.x_W;
  }

  void tryTowards(const Vec3& along_W) noexcept
  {
    const double length = along_W.norm();
    if (length <= this->resolution_.tol())
    {
      return;
    }
    const Vec3 way_W = this->way_u_ / length * along_W;
    const Vec3 y_W = this->slides_ ? this->slid(way_W) : this->straight(way_W);
    const double clear_u = this->clearOf(y_W);
    if (clear_u > this->best_u_)
    {
      this->best_u_ = clear_u;
      this->best_W_ = y_W;
    }
  }

  const AnyScene& from_;
  const AnyScene& to_;
  const ContactPlan& plan_;
  Vec3 x_W_;
  Resolution resolution_;
  std::array<Exchange, mostNear> near_;
  std::size_t count_ = 0;
  double way_u_ = 0.0;
  double tolerance_u_ =
    0.0;                ///< at that distance from the coarser surface a place lies beyond the space between the two
  bool slides_ = false; ///< round an obstacle
  double best_u_ = 0.0; ///< how clear of them all the best place is
  Vec3 best_W_;
};

} // namespace

template<SceneView AnyScene>
std::optional<Vec3> keepSide(
  const AnyScene& from, const AnyScene& to, const ContactPlan& plan, const Vec3& p_W, const Vec3& x_W) noexcept
{
  return SideKeeper<AnyScene>(from, to, plan, x_W).run(p_W);
}

template std::optional<Vec3> keepSide(
  const Scene&, const Scene&, const ContactPlan&, const Vec3&, const Vec3&) noexcept;
template std::optional<Vec3> keepSide(
  const MovingScene&, const MovingScene&, const ContactPlan&, const Vec3&, const Vec3&) noexcept;

} // namespace palpate
