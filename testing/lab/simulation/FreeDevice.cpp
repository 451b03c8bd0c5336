// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/lab/simulation/FreeDevice.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "testing/lab/simulation/WallRig.h"

namespace palpate::lab
{

FreeDevice FreeDevice::linear() const
{
  FreeDevice plain = *this;
  plain.model.friction_N = plain.model.encoderStep_m = 0.0;
  plain.model.maxForce_N = plain.model.travel_m = DeviceModel::unlimited;
  plain.model.planar = false; // these experiments move along z
  return plain;
}

std::unique_ptr<SimulatedDevice> makeFree(const FreeDevice& what, double period_s)
{
  SimulationOptions options;
  options.period_s = period_s;
  options.delay_ticks = what.delay_ticks;
  options.push_D = { 0, 0, -what.push_N };
  options.velocity_D = { 0, 0, what.speed_m_per_s };
  DeviceModel model = what.model;
  model.planar = false;
  model.travel_m = DeviceModel::unlimited;
  auto device =
    std::make_unique<SimulatedDevice>(model, *handModel("none"), HandPath{ { Vec3(0, 0, what.z_m) } }, options);
  if (const std::string problem = device->open(); !problem.empty())
  {
    throw std::invalid_argument(problem);
  }
  return device;
}

std::optional<double> swing_m(WallRig& rig, const SimulatedDevice& device, int ticks, int from)
{
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (int tick = 0; tick < ticks; ++tick)
  {
    rig.tick();
    const double z = device.position_D().z();
    if (!(z > -1.0 && z < 1.0))
    {
      return std::nullopt;
    }
    if (tick >= from)
    {
      low = std::min(low, z);
      high = std::max(high, z);
    }
  }
  return high - low;
}

} // namespace palpate::lab
