// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/plan/PlaneWorld.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "haptics/force/DeviceWalls.h"

namespace palpate
{
namespace
{

/// Of the direction of a normal.
constexpr double rounding = 1e-6;

constexpr double slide_m_per_s = 0.1;

bool movesInPlane(const DeviceInfo& device) noexcept
{
  return device.abilities.sensedAxes == 2;
}

const char* whyByProgram(const DeviceInfo& device, const PlaneWishes& wishes)
{
  if (!device.abilities.holdsWalls)
  {
    return ", because the device holds none";
  }
  if (!device.closesWalls())
  {
    return ", because the device has no viscosity and corridors would vibrate";
  }
  return !wishes.holdWalls ? ", as set" : ", because the plane is not the plane of the device";
}

} // namespace

bool raisesLines(AutoChoice choice, const DeviceInfo& device) noexcept
{
  return choice == AutoChoice::On || (choice == AutoChoice::Auto && movesInPlane(device));
}

HapticParameters inPlane(
  HapticParameters parameters, const std::optional<Pose>& plane_WP, const PlaneWishes& wishes, const DeviceInfo& device)
{
  parameters.guide.on = plane_WP && wishes.guide;
  if (plane_WP)
  {
    parameters.guide.point_W = plane_WP->p;
    parameters.guide.normal_W = (plane_WP->q * Vec3::UnitZ()).normalized();
  }
  parameters.guide.largest_N = movesInPlane(device) ? 0.0 : GuidePlan().largest_N;
  const Vec3 across_W = parameters.map.q_WD * Vec3::UnitZ();
  parameters.walls.hold = plane_WP && movesInPlane(device) && wishes.holdWalls &&
                          across_W.cross(parameters.guide.normal_W).norm() <= rounding;
  return parameters;
}

double feltStiffness_N_per_m(
  const HapticParameters& parameters, const DeviceInfo& device, const StabilityLimits& limits) noexcept
{
  const bool held = parameters.walls.hold && device.closesWalls();
  const double limit_N_per_m = held ? device.heldStiffness_N_per_m.value : StabilityLimits::unlimited;
  return std::min({ parameters.stiffness_N_per_m, limits.largest_N_per_m, limit_N_per_m });
}

double slantDrag_N(const HapticParameters& parameters, double stiffness_N_per_m, double period_s)
{
  Slide slide;
  slide.stiffness_N_per_m = stiffness_N_per_m;
  slide.speed_m_per_s = slide_m_per_s;
  slide.depth_m = 1.0; // both walls press
  slide.host_s = parameters.walls.every_s;
  slide.device_s = period_s;
  slide.lean = std::sqrt(0.5);
  return velvet(slide).mean_N;
}

std::string planeText(const HapticParameters& parameters, const PlaneWishes& wishes, const DeviceInfo& device,
  double drag_N, const std::string& whyNotHeld)
{
  std::ostringstream text;
  text.precision(3);
  text << ", in one plane: ";
  if (parameters.walls.hold && device.closesWalls())
  {
    text << "the device itself holds at most four walls, updated at " << 1.0 / parameters.walls.every_s
         << " Hz: sliding at " << slide_m_per_s << " m/s along a slanted wall meets a drag of " << drag_N << " N";
  }
  else if (!device.closesWalls() && device.offersWalls)
  {
    text << "the program renders the walls: the device offers walls of its own, but " << whyNotHeld;
  }
  else
  {
    text << "the program renders the walls" << whyByProgram(device, wishes);
  }
  text << (parameters.guide.on && parameters.guide.largest_N > 0.0 ? "; the hand is guided to the plane" : "");
  return text.str();
}

} // namespace palpate
