// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>

#include "haptics/contact/carry/Deformation.h"
#include "haptics/contact/carry/HandOver.h"
#include "haptics/contact/carry/KeepSide.h"
#include "haptics/contact/carry/SameFeature.h"
#include "haptics/contact/sweep/Sweep.h"
#include "haptics/contact/view/PlanFor.h"
#include "haptics/contact/view/SceneView.h"

namespace palpate
{
namespace
{

/// Puts the ball in front of a surface of the new scene that has come between it and the outside.
template<SceneView AnyScene>
void stayOutside(
  const AnyScene& from, const AnyScene& to, const ContactPlan& plan, const Vec3& p_W, GodObjectState& state) noexcept
{
  const Vec3 inside_W = state.x_W;
  const Vec3 outside_W = inside_W + 2 * (inside_W - p_W);
  const SweepHit before = sweepStraight(from, plan, plan.radius_u, inside_W, outside_W);
  const double outward = before.hit ? 0.5 * before.t : before.freeUntil;
  state.x_W = stopBefore(to, plan, plan.radius_u, inside_W + outward * (outside_W - inside_W), inside_W);
}

template<SceneView AnyScene>
bool takeOver(
  const AnyScene& from, const AnyScene& to, const ContactPlan& plan, const Vec3& p_W, GodObjectState& state) noexcept
{
  const std::vector<Surface>&before = sceneOf(from).surfaces(), &after = sceneOf(to).surfaces();
  const int touched = state.count;
  int kept = 0;
  for (int i = 0; i < touched; ++i)
  {
    ActiveFeature f = state.features[i];
    f.surface = successorOf(before, f.surface, after);
    const std::optional<ActiveFeature> is =
      f.surface < after.size() ? std::optional(f) : sameFeature(sceneOf(from), state.features[i], sceneOf(to));
    if (is)
    {
      state.features[kept++] = *is;
    }
  }
  state.count = kept;
  if (const std::optional<Vec3> kept_W = state.placed ? keepSide(from, to, plan, p_W, state.x_W) : std::nullopt)
  {
    state.x_W = *kept_W;
  }
  else if (kept < touched)
  {
    stayOutside(from, to, plan, p_W, state);
  }
  return carryWithVertices(from, to, plan, state);
}

} // namespace

bool handOver(
  const Scene& from, const Scene& to, const ContactPlan& plan, const Vec3& p_W, GodObjectState& state) noexcept
{
  return takeOver(from, to, planFor(sceneOf(to), plan), p_W, state);
}

bool handOver(const MovingScene& from, const MovingScene& to, const ContactPlan& plan, const Vec3& p_W,
  GodObjectState& state) noexcept
{
  return takeOver(from, to, planFor(sceneOf(to), plan), p_W, state);
}

} // namespace palpate
