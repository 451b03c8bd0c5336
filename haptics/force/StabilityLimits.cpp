// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/force/StabilityLimits.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "haptics/force/SampledWall.h"

namespace palpate
{
namespace
{

/// Modelling stops here: joints flex, amplifiers lag, and the estimate of the velocity is not the plain difference.
constexpr double shareOfStable = 0.8;

/// Whole ticks, rounded up: half a tick more of delay is never safer.
int wholeTicks(double delay_ticks)
{
  return static_cast<int>(std::ceil(delay_ticks));
}

/// Damping of the controller in units of K T: least and, while it repays, most.
struct Lead
{
  double least = 0.0, most = 0.0;
};

Lead leadOf(const PassivityPlan& plan)
{
  const double ahead = plan.enabled ? 0.5 + plan.delay_ticks + plan.reserve : 0.0;
  return { ahead, plan.enabled ? ahead + plan.repay : 0.0 };
}

/// A link that carries fewer forces than the loop makes is the loop: while one is held the next is under way.
LoopSettings throughLink(const DeviceInfo& device, LoopSettings loop)
{
  const double share = loop.period_s / device.forceUpdate_s.value;
  if (share < 1.0)
  {
    loop.passivity.delay_ticks = 1.0 + share * loop.passivity.delay_ticks;
    loop.period_s = device.forceUpdate_s.value;
  }
  return loop;
}

/// The moving part and the light hand that may hold it, or a turning part as it is felt at a lever.
struct MovingPart
{
  double mass_kg, damping_Ns_per_m;
  double handMass_kg = 0.02, handDamping_Ns_per_m = 2.0, handStiffness_N_per_m = 200.0;
};

MovingPart atLever(const DeviceInfo& device, double lever_m)
{
  constexpr double handInertia_kg_m2 = 5e-5, handDamping_Nms = 0.005, handStiffness_Nm_per_rad = 0.5;
  const double lever2_m2 = lever_m * lever_m;
  return { device.turnInertia_kg_m2.value / lever2_m2, device.turnDamping_Nms.value / lever2_m2,
    handInertia_kg_m2 / lever2_m2, handDamping_Nms / lever2_m2, handStiffness_Nm_per_rad / lever2_m2 };
}

SampledWall wallOf(const MovingPart& part, const LoopSettings& loop)
{
  SampledWall wall;
  wall.mass_kg = part.mass_kg;
  wall.damping_Ns_per_m = part.damping_Ns_per_m;
  wall.period_s = loop.period_s;
  wall.delay_ticks = wholeTicks(loop.passivity.delay_ticks);
  wall.virtualDamping_Ns_per_m = loop.damping_Ns_per_m;
  if (!loop.passivity.enabled)
  {
    wall.handStiffness_N_per_m = part.handStiffness_N_per_m;
    wall.damping_Ns_per_m += part.handDamping_Ns_per_m;
    wall.mass_kg += part.handMass_kg;
  }
  return wall;
}

/// Too much damping shakes a sampled wall like too little: both ends of the controller's range must be stable. The
/// controller leads by periods of `tick_s`, however slow the link is.
double stableStiffness(SampledWall wall, const PassivityPlan& plan, double tick_s)
{
  const Lead lead = leadOf(plan);
  const double share = tick_s / wall.period_s;
  wall.leadPeriods = share * lead.least;
  const double least = criticalStiffness(wall);
  wall.leadPeriods = share * lead.most;
  return std::min(least, criticalStiffness(wall));
}

std::string format(const char* pattern, double value)
{
  char text[160];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

/// Why it is no more.
std::string reasonOf(const StabilityLimits& limits, const DeviceInfo& device, const LoopSettings& loop)
{
  if (limits.decides == StiffnessLimit::Device)
  {
    return "the device's own limit";
  }
  const std::string share = format("80 %% of the stability limit of the loop at %.0f Hz", 1.0 / loop.period_s);
  if (limits.decides == StiffnessLimit::Loop)
  {
    return share + format(" with %.3g kg", device.mass_kg.value) +
           format(" and %.3g N s/m", device.damping_Ns_per_m.value);
  }
  const double lever2_m2 = loop.lever_m * loop.lever_m;
  return share + format(" when the tool turns, %.3g N m/rad", limits.largest_N_per_m * lever2_m2) +
         format(" at a lever of %.3g mm", 1e3 * loop.lever_m) +
         format(" with %.3g kg m2", device.turnInertia_kg_m2.value) +
         format(" and %.3g N m s", device.turnDamping_Nms.value);
}

} // namespace

StabilityLimits stabilityLimits(const DeviceInfo& device, const LoopSettings& asked)
{
  const LoopSettings loop = throughLink(device, asked);
  StabilityLimits limits;
  if (!device.rendersForce)
  {
    return limits;
  }
  limits.device_N_per_m = device.maxStiffness_N_per_m.value;
  if (device.mass_kg.value > 0.0)
  {
    const double lag_s = (0.5 + loop.passivity.delay_ticks) * loop.period_s;
    limits.passive_N_per_m = std::max(0.0, device.damping_Ns_per_m.value - loop.damping_Ns_per_m) / lag_s;
    limits.stable_N_per_m = stableStiffness(
      wallOf({ device.mass_kg.value, device.damping_Ns_per_m.value }, loop), asked.passivity, asked.period_s);
  }
  if (device.resolution_m.value > 0.0)
  {
    limits.quantised_N_per_m = 2.0 * device.friction_N.value / device.resolution_m.value;
  }
  if (loop.lever_m > 0.0 && device.rendersTorque && device.turnInertia_kg_m2.value > 0.0)
  {
    limits.turning_N_per_m =
      stableStiffness(wallOf(atLever(device, loop.lever_m), loop), asked.passivity, asked.period_s);
  }
  const double wayLimit = shareOfStable * limits.stable_N_per_m;
  const double loopLimit = std::min(wayLimit, shareOfStable * limits.turning_N_per_m);
  limits.largest_N_per_m = std::min(limits.device_N_per_m, loopLimit);
  if (std::isfinite(limits.largest_N_per_m))
  {
    limits.decides = limits.device_N_per_m <= loopLimit ? StiffnessLimit::Device
                     : loopLimit < wayLimit             ? StiffnessLimit::Turning
                                                        : StiffnessLimit::Loop;
    limits.grain_N = limits.largest_N_per_m * device.resolution_m.value;
  }
  return limits;
}

std::string describe(const StabilityLimits& limits, const DeviceInfo& device, const LoopSettings& asked)
{
  const LoopSettings loop = throughLink(device, asked);
  if (limits.decides == StiffnessLimit::None)
  {
    return device.rendersForce ? "any stiffness: mass and damping of this device are unknown"
                               : "any stiffness: this device renders no force";
  }
  std::string text = format("up to %.0f N/m: ", limits.largest_N_per_m) + reasonOf(limits, device, loop);
  if (!loop.passivity.enabled)
  {
    text += ", in a light hand, without the passivity controller";
  }
  if (std::isfinite(limits.passive_N_per_m))
  {
    text += format("; passive by its own damping up to %.0f N/m", limits.passive_N_per_m);
  }
  if (std::isfinite(limits.quantised_N_per_m))
  {
    text += format("; friction covers the resolution of the encoder up to %.0f N/m", limits.quantised_N_per_m);
  }
  return text;
}

} // namespace palpate
