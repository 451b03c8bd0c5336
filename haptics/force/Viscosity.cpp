// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/force/Viscosity.h"

#include <algorithm>
#include <cmath>

#include "haptics/force/LinearPlant.h"

namespace palpate
{
namespace
{

double force_N(const Corridor& corridor, double viscosity_Ns_per_m, double x_m, double v_m_per_s)
{
  const double depth_m = std::max(0.0, std::fabs(x_m) - corridor.halfWidth_m);
  const double wanted_N = -std::copysign(corridor.stiffness_N_per_m * depth_m, x_m) - viscosity_Ns_per_m * v_m_per_s;
  return std::clamp(wanted_N, -corridor.maxForce_N, corridor.maxForce_N);
}

} // namespace

Throw throwIn(const Corridor& corridor, double viscosity_Ns_per_m, double duration_s)
{
  constexpr double mostPeriods = 1e6, tail = 0.9;
  const LinearPlant plant(corridor.mass_kg, corridor.damping_Ns_per_m, 0.0, corridor.period_s);
  const auto periods = static_cast<long>(std::min(mostPeriods, duration_s / corridor.period_s));
  Eigen::Vector2d state(0.0, corridor.speed_m_per_s); // x [m], v [m/s]
  Throw end;
  for (long k = 0; k < periods; ++k)
  {
    const double u_N = force_N(corridor, viscosity_Ns_per_m, state.x(), state.y());
    state = plant.free() * state + plant.held() * u_N;
    if (static_cast<double>(k) >= tail * static_cast<double>(periods))
    {
      end.speed_m_per_s = std::max(end.speed_m_per_s, std::fabs(state.y()));
      end.reach_m = std::max(end.reach_m, std::fabs(state.x()));
    }
  }
  return end;
}

bool decays(const Corridor& corridor, double viscosity_Ns_per_m, double within_s)
{
  constexpr double decayed = 0.1, tail = 0.9;
  // The last tenth of a run begins when the handle should have come to rest.
  return throwIn(corridor, viscosity_Ns_per_m, within_s / tail).speed_m_per_s <
         decayed * std::fabs(corridor.speed_m_per_s);
}

std::optional<double> smallestViscosity(const Corridor& corridor, double within_s)
{
  if (decays(corridor, 0.0, within_s))
  {
    return 0.0;
  }
  constexpr double least = 1e-4, factor = 1.25, fine = 1.05;
  const double most = corridor.mass_kg / corridor.period_s;
  double below = 0.0, enough = least * most;
  while (!decays(corridor, enough, within_s))
  {
    below = enough;
    enough *= factor;
    if (enough > most)
    {
      return std::nullopt;
    }
  }
  while (below > 0.0 && enough > fine * below)
  {
    const double middle = std::sqrt(below * enough);
    (decays(corridor, middle, within_s) ? enough : below) = middle;
  }
  return enough;
}

double corridorViscosity(const DeviceInfo& device, double stiffness_N_per_m)
{
  constexpr double usualMass_kg = 0.05, usualForce_N = 5.0, loop_s = 1e-3, thrown_m_per_s = 0.1;
  constexpr double narrow_m = 0.125e-3, wide_m = 4e-3; // from the middle
  Corridor corridor;
  corridor.stiffness_N_per_m = stiffness_N_per_m;
  corridor.maxForce_N = std::isfinite(device.maxForce_N.value) ? device.maxForce_N.value : usualForce_N;
  corridor.mass_kg = device.mass_kg.value > 0.0 ? device.mass_kg.value : usualMass_kg;
  corridor.damping_Ns_per_m = device.damping_Ns_per_m.value;
  corridor.period_s = loop_s;
  corridor.speed_m_per_s = thrown_m_per_s;
  double most = 0.0;
  for (corridor.halfWidth_m = narrow_m; corridor.halfWidth_m <= wide_m; corridor.halfWidth_m *= 2)
  {
    most = std::max(most, smallestViscosity(corridor).value_or(corridor.mass_kg / loop_s));
  }
  return most;
}

} // namespace palpate
