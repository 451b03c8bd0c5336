// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/recording/TickRecord.h"

namespace palpate
{
namespace
{

/// Wall i of a command stands across one of the four directions; which says its normal.
RecordedWalls wallsOf(const DeviceCommand& command) noexcept
{
  RecordedWalls walls;
  for (std::size_t i = 0; i < command.wallCount; ++i)
  {
    const DeviceWall& wall = command.walls[i];
    for (int k = 0; k < AxisWalls::count; ++k)
    {
      if (wall.normal_D == AxisWalls::direction(k))
      {
        walls.mask = static_cast<std::uint8_t>(walls.mask | 1u << k);
        walls.offset_m[static_cast<std::size_t>(k)] = wall.offset_m;
        walls.stiffness_N_per_m = wall.stiffness_N_per_m;
        walls.largest_N[static_cast<std::size_t>(k)] = wall.largest_N;
      }
    }
  }
  walls.viscosity_Ns_per_m = command.viscosity_Ns_per_m;
  return walls;
}

} // namespace

std::uint32_t recordFlags(const HapticState& s) noexcept
{
  std::uint32_t flags = 0;
  for (const bool flag : { s.stiffnessLimited, s.held, s.infeasible, s.overBudget, s.capped, s.riseLimited, s.clamped })
  {
    flags = flags << 1 | static_cast<std::uint32_t>(flag);
  }
  return flags;
}

TickRecord makeRecord(const TickInput& input, const TickOutput& output) noexcept
{
  return { input.tick, input.dt_s, input.sample, input.status, input.lateness, input.hand, output.command.wrench_D,
    output.state.proxy_W, output.state.contacts, output.state.sceneRevision, output.state.energy.delivered_J,
    output.state.energy.excess_J, recordFlags(output.state), wallsOf(output.command), output.command.signal,
    output.state.turned_J, output.command.target };
}

} // namespace palpate
