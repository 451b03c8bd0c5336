// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>

#include "haptics/recording/ByteStream.h"

namespace palpate
{

/// What a chunk of a recording holds.
enum class ChunkType : std::uint32_t
{
  Tick = 1,
  Change = 2,
  Scene = 3,
  End = 4,
  Motion = 5,
};

/// What a recording begins with, before the number of its format.
inline constexpr std::string_view recordingMagic = "PALPATE-RECORDING ";

/// Puts or gets, so that each value is named once, for writing and for reading alike.
struct Put
{
  ByteWriter& stream;
  template<class T>
  void operator()(const T& value) const
  {
    this->stream.put(value);
  }
};

struct Get
{
  ByteReader& stream;
  template<class T>
  void operator()(T& value) const
  {
    this->stream.get(value);
  }
};

template<class Io, class T>
void layWrench(const Io& io, T& w)
{
  io(w.force);
  io(w.torque);
}

template<class Io, class T>
void layMap(const Io& io, T& m)
{
  io(m.scale_u_per_m);
  io(m.q_WD);
  io(m.offset_W);
}

template<class Io, class T>
void layTick(const Io& io, T& r)
{
  io(r.tick);
  io(r.dt_s);
  io(r.sample.time_s);
  io(r.sample.pose_D);
  io(r.sample.velocity_D.linear);
  io(r.sample.velocity_D.angular);
  layWrench(io, r.sample.sensed_D);
  io(r.sample.buttons);
  io(r.sample.grip);
  io(r.status);
  io(r.lateness.stiffnessFactor);
  io(r.lateness.fault);
  io(r.tool);
  layWrench(io, r.wrench_D);
  io(r.proxy_W);
  io(r.contacts);
  io(r.sceneRevision);
  io(r.delivered_J);
  io(r.excess_J);
  io(r.flags);
  for (auto& offset_m : r.walls.offset_m)
  {
    io(offset_m);
  }
  io(r.walls.mask);
  io(r.walls.stiffness_N_per_m);
  for (auto& largest_N : r.walls.largest_N)
  {
    io(largest_N);
  }
  io(r.walls.viscosity_Ns_per_m);
  io(r.signal);
}

template<class Io, class T>
void layParameters(const Io& io, T& p)
{
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
  layMap(io, p.map);
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

template<class Io, class T>
void layState(const Io& io, T& s)
{
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
  layMap(io, s.map);
  io(s.radius_u);
  io(s.sceneRevision);
  io(s.sceneGeometry);
  io(s.sceneAge_s);
  io(s.sinceBad_s);
  io(s.sinceBadBefore_s);
}

template<class Io, class T>
void layChange(const Io& io, T& c)
{
  io(c.event.tick);
  io(c.event.kind);
  io(c.event.value);
  io(c.sceneHash);
  io(c.sceneRevision);
}

template<class Io, class T>
void layMaterial(const Io& io, T& m)
{
  io(m.stiffness_N_per_m);
  io(m.frictionStatic);
  io(m.frictionKinetic);
}

} // namespace palpate
