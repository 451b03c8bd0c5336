// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>

#include "haptics/recording/ByteStream.h"
#include "haptics/tick/ForceRenderer.h"

namespace palpate
{

/// What format 5 had by number and place where today's has names. Nothing writes it any more, so nothing here changes:
/// what stages have learnt since keeps its default.

/// The name of a chunk that format 5 knew by number; empty for a number it did not know.
[[nodiscard]] constexpr std::string_view chunkName5(std::uint32_t number) noexcept
{
  constexpr std::string_view names[] = { "", "tick", "change", "scene", "end", "motion" };
  return number < std::size(names) ? names[number] : "";
}

inline void getMap5(ByteReader& in, WorkspaceMap& m)
{
  const auto io = [&in](auto& value) { in.get(value); };
  io(m.scale_u_per_m);
  io(m.q_WD);
  io(m.offset_W);
}

inline void getParameters5(ByteReader& in, HapticParameters& p)
{
  const auto io = [&in](auto& value) { in.get(value); };
  io(p.stiffness_N_per_m);
  io(p.damping_Ns_per_m);
  io(p.limitStiffness);
  io(p.stiffnessLimit_N_per_m);
  io(p.passivity.enabled);
  io(p.passivity.delay_ticks);
  io(p.passivity.reserve);
  io(p.passivity.repay);
  io(p.velocity.method);
  io(p.velocity.resolution_m);
  io(p.velocity.lowPass_s);
  io(p.velocity.window);
  io(p.sceneBlend_s);
  io(p.contact.radius_u);
  io(p.contact.friction.statical);
  io(p.contact.friction.kinetic);
  io(p.contact.shading);
  io(p.contact.passCap);
  io(p.contact.workBudget);
  io(p.walls.hold);
  io(p.walls.every_s);
  io(p.walls.step_m);
  io(p.walls.viscosity_Ns_per_m);
  io(p.guide.on);
  io(p.guide.point_W);
  io(p.guide.normal_W);
  io(p.guide.stiffness_N_per_m);
  io(p.guide.largest_N);
  io(p.guide.ramp_s);
  io(p.game.on);
  io(p.game.start_W);
  io(p.game.exit_W);
  io(p.game.exitReach_u);
  io(p.game.lead_m_per_s);
  io(p.game.stiffness_N_per_m);
  io(p.game.damping_Ns_per_m);
  io(p.game.largest_N);
  io(p.game.near_m);
  io(p.game.fade_s);
  io(p.game.shake_N);
  io(p.game.shake_Hz);
  io(p.game.shake_s);
  getMap5(in, p.map);
  io(p.safety.maxForce_N);
  io(p.safety.maxRise_N_per_s);
  io(p.safety.engageRamp_s);
  io(p.safety.engageBelow_N);
  io(p.safety.releaseRamp_s);
  io(p.safety.faultRamp_s);
  io(p.safety.needsEngage);
  io(p.safety.deadMan.buttons);
  io(p.safety.deadMan.grip);
  io(p.safety.hand.speed_m_per_s);
  io(p.safety.hand.excess_J);
  io(p.safety.frozenAbove_N);
}

inline void getState5(ByteReader& in, RendererState& s)
{
  const auto io = [&in](auto& value) { in.get(value); };
  io(s.contact.x_W);
  io(s.contact.placed);
  io(s.contact.slips);
  io(s.contact.count);
  for (auto& f : s.contact.features)
  {
    io(f.surface);
    io(f.a);
    io(f.b);
    io(f.kind);
    io(f.side);
    io(f.stuck);
  }
  io(s.engage);
  io(s.fault);
  io(s.gain);
  io(s.watch.same_s);
  io(s.lastForce_D);
  io(s.lastRendered_D);
  io(s.blend_D);
  io(s.velocity.count);
  io(s.tracked);
  getMap5(in, s.map);
  io(s.radius_u);
  io(s.sceneRevision);
  io(s.sceneGeometry);
  io(s.sceneAge_s);
  io(s.sinceBad_s);
  io(s.sinceBadBefore_s);
}

} // namespace palpate
