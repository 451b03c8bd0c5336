// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/HapticParameters.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{

bool nonNegative(double value)
{
  return std::isfinite(value) && value >= 0.0;
}

/// A limit may be infinite, never a number that lets everything pass unseen.
bool usable(const SafetyLimits& s)
{
  const auto limits = { s.maxForce_N, s.maxRise_N_per_s, s.engageRamp_s, s.engageBelow_N, s.releaseRamp_s,
    s.faultRamp_s, s.hand.speed_m_per_s, s.hand.excess_J, s.frozenAbove_N };
  return std::all_of(limits.begin(), limits.end(), [](double limit) { return limit >= 0.0; });
}

bool usable(const PassivityPlan& plan)
{
  constexpr double longestDelay_ticks = 16.0;
  return nonNegative(plan.delay_ticks) && plan.delay_ticks <= longestDelay_ticks && nonNegative(plan.reserve) &&
         nonNegative(plan.repay);
}

bool usable(const FrictionPlan& friction)
{
  constexpr double largest = 10.0;
  return nonNegative(friction.kinetic) && friction.kinetic <= friction.statical && friction.statical <= largest;
}

bool usable(const HeldWallPlan& walls)
{
  return nonNegative(walls.every_s) && nonNegative(walls.step_m) && nonNegative(walls.viscosity_Ns_per_m);
}

bool usable(const GuidePlan& guide)
{
  constexpr double rounding = 1e-6;
  return guide.point_W.allFinite() && std::fabs(guide.normal_W.norm() - 1.0) < rounding &&
         nonNegative(guide.stiffness_N_per_m) && nonNegative(guide.largest_N) && nonNegative(guide.ramp_s);
}

bool usable(const VelocityFilter& filter)
{
  return nonNegative(filter.resolution_m) && nonNegative(filter.lowPass_s) && filter.window >= 1 &&
         filter.window < VelocityHistory::capacity && filter.method <= VelocityMethod::AdaptiveWindow;
}

} // namespace

std::string HapticParameters::validate() const
{
  if (!nonNegative(this->stiffness_N_per_m))
  {
    return "stiffness [N/m] must be a number that is not negative";
  }
  if (!nonNegative(this->damping_Ns_per_m))
  {
    return "damping [N s/m] must be a number that is not negative";
  }
  if (!(this->stiffnessLimit_N_per_m >= 0.0))
  {
    return "largest stiffness [N/m] must be a number that is not negative";
  }
  if (!usable(this->passivity))
  {
    return "passivity: delay [ticks, at most 16], reserve and repay [K T] must be numbers that are not negative";
  }
  if (!usable(this->velocity))
  {
    return "velocity: resolution [m] and time constant [s] must not be negative, the window 1 to " +
           std::to_string(VelocityHistory::capacity - 1) + " ticks";
  }
  if (!nonNegative(this->contact.radius_u))
  {
    return "radius [scene units] must be a number that is not negative";
  }
  if (!usable(this->contact.friction))
  {
    return "friction: the kinetic coefficient must be a number from 0 to the static one, which is at most 10";
  }
  if (!nonNegative(this->map.scale_u_per_m) || this->map.scale_u_per_m == 0.0)
  {
    return "scale [scene units per metre] must be a number above zero";
  }
  if (!this->map.offset_W.allFinite() || !(std::fabs(this->map.q_WD.norm() - 1.0) < 1e-6))
  {
    return "the device's place in the scene must be finite and its rotation a unit quaternion";
  }
  if (!nonNegative(this->sceneBlend_s))
  {
    return "scene blend time [s] must be a number that is not negative";
  }
  if (!usable(this->walls))
  {
    return "held walls: period [s], step [m] and viscosity [N s/m] must be numbers that are not negative";
  }
  if (!usable(this->guide))
  {
    return "guide: the point must be finite, the normal a unit vector, stiffness [N/m], limit [N] and ramp [s] not "
           "negative";
  }
  if (this->game.on && !refuse(this->game).empty())
  {
    return refuse(this->game);
  }
  if (!usable(this->safety))
  {
    return "safety limits [N, N/s, s] must be numbers that are not negative";
  }
  return {};
}

} // namespace palpate
