// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "haptics/contact/GodObject.h"
#include "haptics/contact/PosedSurface.h"
#include "haptics/contact/Sweep.h"

namespace palpate
{
namespace
{

template<class SceneView>
SweepHit sweepFree(const SceneView& scene, const ContactPlan& plan, const Vec3& from_W, const Vec3& to_W) noexcept
{
  SweepQuery query;
  query.from_W = from_W;
  query.to_W = to_W;
  query.radius_u = plan.radius_u;
  query.resolution.include(from_W);
  query.resolution.include(to_W);
  query.resolution.include(Vec3::Constant(plan.radius_u));
  return sweepBall(scene, query, plan.nodeBudget);
}

/// Puts the ball in front of a surface of the new scene that has come between it and the outside.
template<class SceneView>
void stayOutside(const SceneView& from, const SceneView& to, const ContactPlan& plan, const Vec3& p_W, GodObjectState& state) noexcept
{
  const Vec3 inside_W = state.x_W;
  Vec3 outside_W = inside_W + 2 * (inside_W - p_W);
  const SweepHit before = sweepFree(from, plan, inside_W, outside_W);
  outside_W = inside_W + (before.hit ? 0.5 * before.t : before.freeUntil) * (outside_W - inside_W);
  const SweepHit now = sweepFree(to, plan, outside_W, inside_W);
  if (!now.hit)
  {
    return;
  }
  // A point must stop short of what it hits, and the way to where it stops be free exactly.
  for (double shortOf = 1e-9; shortOf < 1.0; shortOf *= 8)
  {
    const Vec3 stop_W = outside_W + std::max(0.0, now.t - shortOf) * (inside_W - outside_W);
    if (!sweepFree(to, plan, outside_W, stop_W).hit)
    {
      state.x_W = stop_W;
      return;
    }
  }
}

template<class SceneView>
void takeOver(const SceneView& from, const SceneView& to, const ContactPlan& plan, const Vec3& p_W, GodObjectState& state) noexcept
{
  const std::vector<Surface>&before = sceneOf(from).surfaces(), &after = sceneOf(to).surfaces();
  const int touched = state.count;
  int kept = 0;
  for (int i = 0; i < touched; ++i)
  {
    ActiveFeature f = state.features[i];
    const auto& tree = before[f.surface].tree;
    const auto same = std::find_if(after.begin(), after.end(),
      [&tree](const Surface& s) { return s.tree->contentHash() == tree->contentHash(); });
    if (same != after.end())
    {
      f.surface = static_cast<std::uint32_t>(same - after.begin());
      state.features[kept++] = f;
    }
  }
  state.count = kept;
  if (kept < touched)
  {
    stayOutside(from, to, plan, p_W, state);
  }
}

} // namespace

void handOver(
  const Scene& from, const Scene& to, const ContactPlan& plan, const Vec3& p_W, GodObjectState& state) noexcept
{
  takeOver(from, to, plan, p_W, state);
}

void handOver(const MovingScene& from, const MovingScene& to, const ContactPlan& plan, const Vec3& p_W,
  GodObjectState& state) noexcept
{
  takeOver(from, to, plan, p_W, state);
}

} // namespace palpate
