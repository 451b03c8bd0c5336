// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/GodObject.h"

#include <utility>

#include "haptics/contact/feel/FrictionMove.h"
#include "haptics/contact/feel/ShadedMove.h"
#include "haptics/contact/feel/SurfaceResponse.h"
#include "haptics/contact/moves/Seat.h"
#include "haptics/contact/sweep/KeptFaces.h"
#include "haptics/contact/view/PlanFor.h"
#include "haptics/contact/view/SceneView.h"

namespace palpate
{
namespace
{

/// True if a tick took so little that it can make lists for those that follow. Long ticks are not made longer.
bool isCheap(const ContactResult& result) noexcept
{
  return result.passes <= 4 && result.sweeps <= 3 && !result.overBudget;
}

template<SceneView AnyScene>
ContactResult move(
  const AnyScene& scene, const ContactPlan& plan, const Vec3& p_W, GodObjectState& state, PathSink* sink) noexcept
{
  if (!state.placed)
  {
    state.count = 0;
    state.slips = false;
    state.texture = -1.0;
    if (!seatBall(scene, plan, p_W, state.x_W))
    {
      ContactResult refused;
      refused.proxy_W = p_W;
      refused.seatFailed = true;
      return refused;
    }
    state.placed = true;
    state.device_W = p_W;
  }
  const Vec3 before_W = state.x_W;
  ContactResult result =
    plan.shading ? moveShaded(scene, plan, p_W, state, sink) : moveUnshaded(scene, plan, p_W, state, sink);
  const bool skips = std::exchange(state.around.skips, false);
  if (isCheap(result) && !skips)
  {
    renewKept(scene, plan.radius_u, before_W, state);
  }
  result.pull_W = result.proxy_W - p_W;
  result.held_u2 = result.pull_W.squaredNorm();
  if (sceneOf(scene).hasMaterials())
  {
    const Response response = respond(scene, plan, result, p_W, p_W - state.device_W, state.texture);
    result.pull_W = response.pull_W;
    result.held_u2 = response.held_u2;
  }
  else
  {
    state.texture = -1.0;
  }
  state.device_W = p_W;
  return result;
}

} // namespace

ContactResult moveGodObject(
  const Scene& scene, const ContactPlan& plan, const Vec3& p_W, GodObjectState& state, PathSink* sink) noexcept
{
  if (scene.moves())
  {
    return moveGodObject(MovingScene(scene, 1.0), plan, p_W, state, sink);
  }
  return move(scene, planFor(sceneOf(scene), plan), p_W, state, sink);
}

ContactResult moveGodObject(
  const MovingScene& scene, const ContactPlan& plan, const Vec3& p_W, GodObjectState& state, PathSink* sink) noexcept
{
  return move(scene, planFor(sceneOf(scene), plan), p_W, state, sink);
}

} // namespace palpate
