// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "haptics/core/HapticDevice.h"
#include "haptics/tick/ForceRenderer.h"

namespace palpate
{

/// The walls of a command as a recording keeps them: of AxisWalls, 0 where there is none.
struct RecordedWalls
{
  std::array<double, AxisWalls::count> offset_m{};
  std::uint8_t mask = 0; ///< bit i: wall i is there
  double stiffness_N_per_m = 0.0;
  std::array<double, AxisWalls::count> largest_N{}; ///< each may push; infinite: as hard as its spring
  double viscosity_Ns_per_m = 0.0;
};

/// The record of one tick: its inputs, and its outputs to compare with.
struct TickRecord
{
  std::uint64_t tick = 0;
  double dt_s = 0.0;
  DeviceSample sample;
  DeviceStatus status = DeviceStatus::Ok;
  LatenessVerdict lateness;
  std::uint32_t hand = 0;
  Wrench wrench_D;
  Pose proxy_W;
  std::int32_t contacts = 0;
  std::uint64_t sceneRevision = 0;
  double delivered_J = 0.0; ///< energy meter: net work on the hand
  double excess_J = 0.0;    ///< and energy that the contact has returned in excess
  std::uint32_t flags = 0;  ///< see recordFlags
  RecordedWalls walls;
  Signal signal = Signal::None;
  double turned_J = 0.0; ///< energy meter: net work of the torque
  PoseTarget target;
};

/// Hands each input of a tick to visit(name, member...); of several records, the same of each.
template<class Visit, class... R>
void inputFields(const Visit& visit, R&... r)
{
  visit("tick", r.tick...);
  visit("period", r.dt_s...);
  visit("sample", r.sample.time_s...);
  visit("sample", r.sample.pose_D...);
  visit("sample", r.sample.velocity_D.linear...);
  visit("sample", r.sample.velocity_D.angular...);
  visit("sample", r.sample.sensed_D.force...);
  visit("sample", r.sample.sensed_D.torque...);
  visit("buttons", r.sample.buttons...);
  visit("grip", r.sample.grip...);
  visit("status", r.status...);
  visit("lateness", r.lateness.stiffnessFactor...);
  visit("lateness", r.lateness.fault...);
  visit("hand", r.hand...);
}

/// And each output.
template<class Visit, class... R>
void outputFields(const Visit& visit, R&... r)
{
  visit("force", r.wrench_D.force...);
  visit("torque", r.wrench_D.torque...);
  visit("proxy", r.proxy_W...);
  visit("contacts", r.contacts...);
  visit("scene", r.sceneRevision...);
  visit("energy", r.delivered_J...);
  visit("energy", r.excess_J...);
  visit("flags", r.flags...);
  for (std::size_t i = 0; i < AxisWalls::count; ++i)
  {
    visit("walls", r.walls.offset_m[i]...);
  }
  visit("walls", r.walls.mask...);
  visit("walls", r.walls.stiffness_N_per_m...);
  for (std::size_t i = 0; i < AxisWalls::count; ++i)
  {
    visit("walls", r.walls.largest_N[i]...);
  }
  visit("viscosity", r.walls.viscosity_Ns_per_m...);
  visit("signal", r.signal...);
  visit("energy of turning", r.turned_J...);
  visit("target", r.target.pose_D...);
  visit("target", r.target.stiffness_N_per_m...);
}

/// The flags of a state as bits: clamped, riseLimited, capped, overBudget, infeasible, held, stiffnessLimited, from the
/// lowest up.
[[nodiscard]] std::uint32_t recordFlags(const HapticState& state) noexcept;
[[nodiscard]] TickRecord makeRecord(const TickInput& input, const TickOutput& output) noexcept;

} // namespace palpate
