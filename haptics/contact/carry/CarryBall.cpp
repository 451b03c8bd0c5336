// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/carry/CarryBall.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "haptics/contact/carry/Deformation.h"
#include "haptics/contact/planes/ContactSet.h"
#include "haptics/contact/sweep/BoxTest.h"
#include "haptics/contact/sweep/Sweep.h"
#include "haptics/contact/sweep/TreeWalk.h"
#include "haptics/contact/view/PlanFor.h"

namespace palpate
{
namespace
{

/// Each attempt adds the first surface that is met. Three planes hold a ball, so eight surfaces that come at a ball in
/// one tick are more than it can evade; after them the last resort decides.
constexpr int attempts = 8;

/// A feature that holds the ball while the surfaces move, and where the ball would be had it stayed with its surface.
struct Holder
{
  ActiveFeature feature;
  Vec3 kept_W;
};

class Carry
{
public:
  Carry(const MovingScene& before, const MovingScene& now, const ContactPlan& plan, GodObjectState& state) noexcept
    : before_(before), now_(now), plan_(plan), state_(state), start_W_(state.x_W)
  {
  }

  CarryResult run() noexcept
  {
    Vec3 to_W = this->start_W_;
    for (int i = 0; i < this->state_.count; ++i)
    {
      this->hold(this->state_.features[static_cast<std::size_t>(i)]);
    }
    if (const Holder* const mover = this->firstMover())
    {
      to_W = this->settled(mover->kept_W);
    }
    for (int attempt = 0; attempt < attempts; ++attempt)
    {
      const std::optional<Holder> met = this->firstMet(to_W);
      if (!met)
      {
        return this->moved(to_W);
      }
      this->add(*met);
      to_W = this->settled(met->kept_W);
    }
    return this->moved(this->lastResort(to_W));
  }

private:
  CarryResult moved(const Vec3& to_W) noexcept
  {
    this->result_.carried = to_W != this->start_W_;
    this->state_.x_W = to_W;
    return this->result_;
  }

  /// Many faces at once: a ball that simply stays with one of the surfaces is not passed by that one at least.
  [[nodiscard]] Vec3 lastResort(const Vec3& settled_W) noexcept
  {
    for (int i = 0; i < this->count_; ++i)
    {
      const Vec3& kept_W = this->holders_[static_cast<std::size_t>(i)].kept_W;
      if (!this->firstMet(kept_W))
      {
        return kept_W;
      }
    }
    this->result_.pinned = true;
    return settled_W;
  }

  /// Where the surface was before, or nothing if it was not there or has not moved.
  [[nodiscard]] std::optional<Pose> poseBefore(std::uint32_t surface) const noexcept
  {
    const auto& surfaces = this->now_.scene().surfaces();
    const auto& earlier = this->before_.scene().surfaces();
    const auto& tree = surfaces[surface].tree;
    const bool sameNumber = surface < earlier.size() && earlier[surface].tree->contentHash() == tree->contentHash();
    const auto was = sameNumber ? earlier.begin() + surface
                                : std::find_if(earlier.begin(), earlier.end(),
                                    [&tree](const Surface& s) { return s.tree->contentHash() == tree->contentHash(); });
    if (was == earlier.end())
    {
      return std::nullopt;
    }
    if (verticesMoved(this->before_, static_cast<std::uint32_t>(was - earlier.begin()), this->now_, surface))
    {
      return std::nullopt; // the ball came along with its vertices, and so with all of its motion
    }
    const Pose old = was->motion.at(this->before_.share()), fresh = surfaces[surface].motion.at(this->now_.share());
    const bool moved = old.p != fresh.p || old.q.coeffs() != fresh.q.coeffs();
    return moved ? std::optional(old) : std::nullopt;
  }

  [[nodiscard]] Vec3 keptWith(std::uint32_t surface) const noexcept
  {
    const std::optional<Pose> old = this->poseBefore(surface);
    if (!old)
    {
      return this->start_W_;
    }
    const PosedSurface was({ surfaceOf(this->now_, surface).data(), nullptr, 1.0 }, *old);
    return surfaceOf(this->now_, surface).toWorld(was.toSurface(this->start_W_));
  }

  void hold(const ActiveFeature& f) noexcept { this->add({ f, this->keptWith(f.surface) }); }

  void add(const Holder& holder) noexcept
  {
    const auto same = [&holder](const Holder& h)
    {
      const ActiveFeature &f = h.feature, &g = holder.feature;
      return f.surface == g.surface && f.kind == g.kind && f.a == g.a && f.b == g.b;
    };
    const auto end = this->holders_.begin() + this->count_;
    const auto known = std::find_if(this->holders_.begin(), end, same);
    if (known != end)
    {
      *known = holder;
    }
    else if (this->count_ < GodObjectState::maxFeatures)
    {
      this->holders_[static_cast<std::size_t>(this->count_++)] = holder;
    }
  }

  [[nodiscard]] const Holder* firstMover() const noexcept
  {
    for (int i = 0; i < this->count_; ++i)
    {
      if (this->holders_[static_cast<std::size_t>(i)].kept_W != this->start_W_)
      {
        return &this->holders_[static_cast<std::size_t>(i)];
      }
    }
    return nullptr;
  }

  /// The place nearest to `wanted` in front of all holders; where there is none for the ball, one for a smaller ball.
  [[nodiscard]] Vec3 settled(const Vec3& wanted_W) noexcept
  {
    ContactSet<MovingScene> contacts(this->now_, this->plan_.radius_u, this->state_);
    contacts.include(wanted_W);
    for (int i = 0; i < this->count_; ++i)
    {
      contacts.include(this->holders_[static_cast<std::size_t>(i)].feature);
    }
    // Surfaces on all sides may have come nearer than the size of the ball: the ball is pinned with the radius that
    // is left.
    for (const double share : { 1.0, 0.5, 0.25, 0.0 })
    {
      std::array<PlaneRow, GodObjectState::maxFeatures> rows;
      for (int i = 0; i < this->count_; ++i)
      {
        const Holder& holder = this->holders_[static_cast<std::size_t>(i)];
        const FeaturePlane plane =
          planeOf(surfaceOf(this->now_, holder.feature.surface), holder.feature, holder.kept_W, 0.0);
        const double distance = share * contacts.radius(holder.feature) + contacts.lift();
        rows[static_cast<std::size_t>(i)] = { plane.n, distance - plane.n.dot(wanted_W - plane.foot_W) };
      }
      const ProjectionResult free = projectOntoPlanes(
        { rows.data(), static_cast<std::size_t>(this->count_) }, Vec3::Zero(), contacts.resolution().slack());
      if (free.feasible)
      {
        this->result_.pinned = share < 1.0;
        return wanted_W + free.y;
      }
      if (this->plan_.radius_u == 0.0)
      {
        break;
      }
    }
    this->result_.pinned = true;
    return wanted_W;
  }

  /// The first surface that the way to a place meets, seen from that surface.
  [[nodiscard]] std::optional<Holder> firstMet(const Vec3& to_W) noexcept
  {
    std::optional<Holder> met;
    double first = 2.0;
    const SweptBall way = sweptBallOf(straightQuery(this->start_W_, to_W, this->plan_.radius_u));
    const auto visit = [&](std::uint32_t surface) noexcept
    {
      const SweepHit hit = this->sweepRelative(surface, to_W);
      if (hit.hit && hit.t < first)
      {
        first = hit.t;
        met = Holder{ hit.feature, this->keptAtHit(hit, surface, to_W) };
      }
      return true;
    };
    // Boxes of moving surfaces hold all of their way.
    static_cast<void>(walkWithin(
      this->now_.scene().surfaceTree().nodes, BoxTest(way), this->plan_.workBudget, this->result_.work, visit));
    return met;
  }

  struct RelativeWay
  {
    Vec3 from_S, to_S;
  };

  [[nodiscard]] RelativeWay relativeWay(std::uint32_t surface, const Vec3& to_W) const noexcept
  {
    const PosedSurface now = surfaceOf(this->now_, surface);
    const std::optional<Pose> old = this->poseBefore(surface);
    const PosedSurface was = old ? PosedSurface({ now.data(), nullptr, 1.0 }, *old) : now;
    return { was.toSurface(this->start_W_), now.toSurface(to_W) };
  }

  [[nodiscard]] SweepHit sweepRelative(std::uint32_t surface, const Vec3& to_W) noexcept
  {
    const RelativeWay way = this->relativeWay(surface, to_W);
    if (this->plan_.radius_u > 0.0 && way.from_S == way.to_S)
    {
      return {}; // a ball that stays meets nothing: it comes nearer to nothing
    }
    SweepQuery query = straightQuery(way.from_S, way.to_S, this->plan_.radius_u);
    query.resolution.include(Vec3::Constant(this->plan_.radius_u));
    std::array<ActiveFeature, GodObjectState::maxFeatures> held;
    if (this->plan_.radius_u > 0.0)
    {
      std::transform(this->holders_.begin(), this->holders_.begin() + this->count_, held.begin(),
        [](const Holder& holder) { return holder.feature; });
      query.touched = { held.data(), static_cast<std::size_t>(this->count_) };
    }
    const PosedSurface now = surfaceOf(this->now_, surface);
    const SweepHit hit = askShape(
      now, [&](const auto& shape) noexcept { return sweepSurface(shape, surface, query, this->plan_.workBudget); });
    this->result_.work += hit.work;
    return hit;
  }

  /// Where the ball would be had it stayed with the surface from the moment that one met it.
  [[nodiscard]] Vec3 keptAtHit(const SweepHit& hit, std::uint32_t surface, const Vec3& to_W) const noexcept
  {
    const RelativeWay way = this->relativeWay(surface, to_W);
    return surfaceOf(this->now_, surface).toWorld(way.from_S + hit.t * (way.to_S - way.from_S));
  }

  const MovingScene& before_;
  const MovingScene& now_;
  const ContactPlan& plan_;
  GodObjectState& state_;
  const Vec3 start_W_;
  std::array<Holder, GodObjectState::maxFeatures> holders_;
  int count_ = 0;
  CarryResult result_;
};

} // namespace

CarryResult carryBall(
  const MovingScene& before, const MovingScene& now, const ContactPlan& plan, GodObjectState& state) noexcept
{
  const ContactPlan fitted = planFor(now.scene(), plan);
  return state.placed ? Carry(before, now, fitted, state).run() : CarryResult{};
}

} // namespace palpate
