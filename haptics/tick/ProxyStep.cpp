// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tick/ProxyStep.h"

#include "haptics/contact/carry/CarryBall.h"
#include "haptics/contact/carry/Deformation.h"
#include "haptics/contact/carry/HandOver.h"

namespace palpate
{
namespace
{

bool sameMap(const WorkspaceMap& a, const WorkspaceMap& b) noexcept
{
  return a.scale_u_per_m == b.scale_u_per_m && a.q_WD.coeffs() == b.q_WD.coeffs() && a.offset_W == b.offset_W;
}

ContactResult moveIn(const ProxyTick& tick, const Vec3& p_W, GodObjectState& contact) noexcept
{
  const Scene& scene = *tick.input.scene;
  return scene.moves()
           ? moveGodObject(MovingScene(scene, scene.shareAt(tick.step.age_s)), tick.plan, p_W, contact, tick.sink)
           : moveGodObject(scene, tick.plan, p_W, contact, tick.sink);
}

/// Takes the ball along to another scene, or on the way that the surfaces of this one made.
void comeAlong(
  const ProxyTick& tick, const Vec3& p_W, double ageBefore_s, GodObjectState& contact, ProxyStep& moved) noexcept
{
  const Scene& scene = *tick.input.scene;
  const Scene* const before = tick.input.previousScene != nullptr ? tick.input.previousScene : &scene;
  if (tick.input.previousScene == nullptr && tick.step.changed)
  {
    contact.count = 0; // features are numbered by their scene
    return;
  }
  if (!scene.moves() && !before->moves())
  {
    if (tick.step.otherGeometry)
    {
      handOver(*before, scene, tick.plan, p_W, contact);
    }
    return;
  }
  const MovingScene was(*before, before->shareAt(ageBefore_s)), is(scene, scene.shareAt(tick.step.age_s));
  if (tick.step.otherGeometry)
  {
    handOver(was, is, tick.plan, p_W, contact);
  }
  else if (before->bends() || scene.bends())
  {
    carryWithVertices(was, is, tick.plan, contact);
  }
  const CarryResult carry = carryBall(was, is, tick.plan, contact);
  moved.pinned = carry.pinned;
  moved.carryWork = carry.work;
}

} // namespace

SceneStep sceneStep(const TickInput& input, const RendererState& state) noexcept
{
  const std::uint64_t revision = input.scene != nullptr ? input.scene->revision() : 0;
  SceneStep step;
  step.changed = input.previousScene != nullptr || revision != state.sceneRevision;
  step.otherGeometry = step.changed && (input.scene == nullptr || input.scene->geometryHash() != state.sceneGeometry);
  step.replaced =
    step.otherGeometry && (input.scene == nullptr || input.scene->continuesGeometry() != state.sceneGeometry);
  step.first = state.sceneRevision == 0;
  step.age_s = (step.changed ? 0.0 : state.sceneAge_s) + input.dt_s;
  return step;
}

ProxyStep moveProxy(const ProxyTick& tick, const Vec3& p_W, RendererState& state) noexcept
{
  GodObjectState& contact = state.contact;
  const bool otherMap = !sameMap(state.map, tick.map);
  const bool otherBall = state.radius_u != tick.plan.radius_u;
  state.map = tick.map;
  state.radius_u = tick.plan.radius_u;
  ProxyStep moved;
  if (!tick.touches)
  {
    contact = GodObjectState{};
    moved.contact.proxy_W = p_W;
    return moved;
  }
  if (otherMap)
  {
    contact.placed = false; // the hand is elsewhere: what lies between was not passed
  }
  else if (otherBall && contact.placed)
  {
    contact.placed = false; // where the old ball was, not at the device: a pressed one stays on its side
    static_cast<void>(moveIn(tick, Vec3(contact.x_W), contact));
  }
  else
  {
    comeAlong(tick, p_W, state.sceneAge_s, contact, moved);
  }
  moved.contact = moveIn(tick, p_W, contact);
  return moved;
}

} // namespace palpate
