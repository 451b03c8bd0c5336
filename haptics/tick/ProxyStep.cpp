// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tick/ProxyStep.h"

#include "haptics/contact/carry/CarryBall.h"
#include "haptics/contact/carry/Deformation.h"
#include "haptics/contact/carry/HandOver.h"
#include "haptics/tick/SoftProxy.h"

namespace palpate
{
namespace
{

ContactResult moveIn(
  const MovingScene& now, const ContactPlan& plan, const Vec3& p_W, GodObjectState& contact, PathSink* sink) noexcept
{
  return now.scene().moves() ? moveGodObject(now, plan, p_W, contact, sink)
                             : moveGodObject(now.scene(), plan, p_W, contact, sink);
}

/// Takes the ball along to another scene, or with the motion of the surfaces of this one.
void comeAlong(const ProxyTick& tick, const MovingScene& now, const ContactPlan& plan, const Vec3& p_W,
  RendererState& state, ProxyStep& moved) noexcept
{
  GodObjectState& contact = state.contact;
  const Scene& scene = now.scene();
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
      moved.pinned = handOver(*before, scene, plan, p_W, contact);
    }
    return;
  }
  FaceCache cache;
  const MovingScene was(*before, before->shareAt(state.sceneAge_s), &cache);
  if (tick.step.otherGeometry)
  {
    moved.pinned = handOver(was, now, plan, p_W, contact);
  }
  else if (before->bends() || scene.bends())
  {
    moved.pinned = carryWithVertices(was, now, plan, contact);
  }
  const CarryResult carry = carryBall(was, now, plan, contact);
  moved.pinned = moved.pinned || carry.pinned;
  moved.carryWork = carry.work;
}

/// The ball of this tick where the old one was, not at the device: a pressed one stays on its side. Nothing changes
/// where it does not fit.
void resize(const ProxyTick& tick, const MovingScene& now, RendererState& state) noexcept
{
  GodObjectState resized = state.contact;
  resized.placed = false;
  if (!moveIn(now, tick.plan, state.contact.x_W, resized, tick.sink).seatFailed)
  {
    state.contact = resized;
    state.radius_u = tick.plan.radius_u;
  }
}

/// Moves the ball from a place that is outside to its place, up to the first surface between. Where nothing was felt
/// before the ball is where the hand is.
void comeFrom(const Vec3& from_W, const MovingScene& now, const ContactPlan& plan, const Vec3& p_W,
  GodObjectState& contact) noexcept
{
  if (!contact.placed)
  {
    contact = GodObjectState{};
    contact.x_W = contact.device_W = p_W;
    contact.placed = true;
  }
  const Vec3 to_W = contact.x_W;
  contact.x_W = now.scene().moves() ? stopBefore(now, plan, plan.radius_u, from_W, to_W)
                                    : stopBefore(now.scene(), plan, plan.radius_u, from_W, to_W);
  contact.count = 0; // the contacts at that place are behind the surface that stops the ball
}

} // namespace

SceneStep sceneStep(const TickInput& input, const LoadedRegion& known, const RendererState& state) noexcept
{
  const std::uint64_t revision = input.scene != nullptr ? input.scene->revision() : 0;
  const std::uint64_t geometry = input.scene != nullptr ? input.scene->geometryHash() : 0;
  SceneStep step;
  // The scenes of a soft body have one revision: after ticks without a finite sample only the geometry tells a change.
  step.changed = input.previousScene != nullptr || revision != state.sceneRevision || geometry != state.sceneGeometry;
  step.otherGeometry = step.changed && (input.scene == nullptr || geometry != state.sceneGeometry);
  const bool samePart = known.geometry != 0 && known.geometry == geometry && known.continues == state.sceneGeometry;
  step.replaced = step.otherGeometry && !samePart &&
                  (input.scene == nullptr || input.scene->continuesGeometry() != state.sceneGeometry);
  step.first = state.sceneRevision == 0;
  step.age_s = (step.changed ? 0.0 : state.sceneAge_s) + input.dt_s;
  return step;
}

ProxyStep moveProxy(const ProxyTick& tick, const Vec3& p_W, RendererState& state) noexcept
{
  GodObjectState& contact = state.contact;
  ProxyStep moved;
  if (!tick.touches)
  {
    contact = GodObjectState{};
    state.soft = SoftState{};
    moved.contact.proxy_W = p_W;
    return moved;
  }
  contact.placed = contact.placed && !tick.elsewhere;
  state.radius_u = contact.placed ? state.radius_u : tick.plan.radius_u;
  ContactPlan plan = tick.plan;
  plan.radius_u = state.radius_u;
  const Scene& scene = *tick.input.scene;
  FaceCache cache;
  const MovingScene now(scene, scene.shareAt(tick.step.age_s), &cache);
  if (!tick.elsewhere)
  {
    comeAlong(tick, now, plan, p_W, state, moved);
  }
  const bool toldToCome = tick.lead.number != state.ballLed && tick.lead.geometry == scene.geometryHash();
  if (toldToCome)
  {
    comeFrom(tick.lead.from_W, now, plan, p_W, contact);
  }
  const bool spent = toldToCome || tick.input.body != nullptr; // a lead past a soft body would come late
  state.ballLed = spent ? tick.lead.number : state.ballLed;
  if (contact.placed && state.radius_u != tick.plan.radius_u)
  {
    resize(tick, now, state);
  }
  plan.radius_u = state.radius_u;
  moved.contact = tick.input.body != nullptr ? moveOnBody(tick, plan, p_W, now.share(), state)
                                             : moveIn(now, plan, p_W, contact, tick.sink);
  return moved;
}

} // namespace palpate
