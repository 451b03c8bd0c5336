// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/simulated/SerialLink.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "haptics/force/DeviceWalls.h"

namespace palpate
{
namespace
{

/// The parameters of a wall; without stiffness there is no wall, and its offset does not matter.
struct Slot
{
  double offset_m = 0.0, stiffness_N_per_m = 0.0;
};

std::array<Slot, AxisWalls::count> slotsOf(const DeviceCommand& command) noexcept
{
  std::array<Slot, AxisWalls::count> slots;
  for (std::size_t k = 0; k < std::min<std::size_t>(command.wallCount, command.walls.size()); ++k)
  {
    const DeviceWall& wall = command.walls[k];
    for (int i = 0; i < AxisWalls::count; ++i)
    {
      if (wall.normal_D == AxisWalls::direction(i))
      {
        slots[static_cast<std::size_t>(i)] = { wall.offset_m, wall.stiffness_N_per_m };
      }
    }
  }
  return slots;
}

} // namespace

double SerialLink::bytesBetween(const DeviceCommand& before, const DeviceCommand& after) noexcept
{
  const auto from = slotsOf(before), to = slotsOf(after);
  double bytes = before.wrench_D.force == after.wrench_D.force ? 0.0 : force_B;
  bytes += before.viscosity_Ns_per_m == after.viscosity_Ns_per_m ? 0.0 : parameter_B;
  for (std::size_t i = 0; i < to.size(); ++i)
  {
    bytes += from[i].stiffness_N_per_m == to[i].stiffness_N_per_m ? 0.0 : parameter_B;
    bytes += to[i].stiffness_N_per_m == 0.0 || from[i].offset_m == to[i].offset_m ? 0.0 : parameter_B;
  }
  return bytes;
}

void SerialLink::send(const DeviceCommand& command, double time_s) noexcept
{
  const double bytes = bytesBetween(this->there_, command);
  this->onItsWay_ = command;
  this->busy_ = bytes > 0.0;
  this->arrives_s_ = time_s + bytes / this->bytes_per_s_;
}

const DeviceCommand& SerialLink::carry(const DeviceCommand& offered, double time_s) noexcept
{
  // The waiting command is sent at each arrival; at the second one nothing has changed, and the loop ends.
  while (this->busy_ && this->arrives_s_ <= time_s)
  {
    this->there_ = this->onItsWay_;
    this->send(this->waiting_, this->arrives_s_);
  }
  this->waiting_ = offered;
  if (!this->busy_)
  {
    this->send(offered, time_s);
  }
  if (this->arrives_s_ <= time_s) // at once: no byte has to be sent, or the link has no limit
  {
    this->there_ = offered;
    this->busy_ = false;
  }
  return this->there_;
}

} // namespace palpate
