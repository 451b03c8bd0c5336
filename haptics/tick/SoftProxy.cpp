// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tick/SoftProxy.h"

#include <algorithm>

#include "haptics/compliance/servo/SoftTick.h"

namespace palpate
{
namespace
{

int pushing(const SoftState& soft) noexcept
{
  return static_cast<int>(std::count_if(soft.contacts.begin(), soft.contacts.begin() + soft.count,
    [](const SoftContact& c) { return c.force_N.squaredNorm() > 0.0; }));
}

/// As the contact of a tick without a soft body tells it.
ContactResult resultOf(const SoftResult& moved, const SoftState& soft, double coupling_N_per_u) noexcept
{
  ContactResult result = moved.core;
  result.proxy_W = moved.proxy_W;
  result.pull_W = moved.force_N / coupling_N_per_u;
  result.held_u2 = result.pull_W.squaredNorm();
  result.capped = result.capped || moved.capped;
  result.overBudget = result.overBudget || moved.overBudget;
  result.work = moved.work;
  result.contacts = soft.count > 0 ? pushing(soft) : result.contacts;
  return result;
}

} // namespace

ContactResult moveOnBody(
  const ProxyTick& tick, const ContactPlan& plan, const Vec3& p_W, double share, RendererState& state) noexcept
{
  const PressedBody& body = *tick.input.body;
  const std::span touch(&body.touch, 1);
  SoftScratch& room = *tick.input.softScratch;
  ContactPlan inUnits = plan;
  inUnits.coupling_N_per_m /= state.map.scale_u_per_m;
  state.soft.core = state.contact;
  FaceCache cache;
  SoftResult moved = body.scene->moves()
                       ? moveOnSoft(MovingScene(*body.scene, share, &cache), inUnits, touch, p_W, state.soft, room)
                       : moveOnSoft(*body.scene, inUnits, touch, p_W, state.soft, room);
  if (body.held && state.soft.count > 0)
  {
    stopAtHeldFaces(*body.held, inUnits, state.soft.core.x_W, p_W, moved);
  }
  state.contact = state.soft.core;
  return resultOf(moved, state.soft, inUnits.coupling_N_per_m);
}

BodyHand bodyHandOf(const TickInput& input, const TickOutput& output, const RendererState& state) noexcept
{
  BodyHand hand;
  hand.tick = input.tick;
  hand.revision = state.softRevision;
  hand.device_W = output.state.device_W.p;
  hand.ball_W = state.contact.placed ? state.contact.x_W : output.state.device_W.p;
  hand.velocity_u_per_s = state.map.scale_u_per_m * state.map.directionToScene(output.state.velocity_D);
  hand.radius_u = state.radius_u;
  const bool pressed = input.body != nullptr && input.body->revision == state.softRevision;
  for (int c = 0; c < state.soft.count && pressed; ++c)
  {
    const SoftContact& contact = state.soft.contacts[c];
    if (contact.soft != nullptr)
    {
      hand.forceAt[hand.count] = contact.point.at;
      hand.force_N[hand.count++] = -contact.force_N;
    }
  }
  return hand;
}

} // namespace palpate
