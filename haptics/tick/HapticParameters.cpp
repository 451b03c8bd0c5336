// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tick/HapticParameters.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace palpate
{
namespace
{

/// How far the length of what must be a unit may be off.
constexpr double unitRounding = 1e-6;

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

/// The tick must end.
bool bounded(const ContactPlan& contact)
{
  constexpr std::uint32_t mostPasses = 1024, mostWork = 10000000;
  return contact.passCap >= 1 && contact.passCap <= mostPasses && contact.workBudget >= 1 &&
         contact.workBudget <= mostWork;
}

bool usable(const HeldWallPlan& walls)
{
  return nonNegative(walls.every_s) && nonNegative(walls.step_m) && nonNegative(walls.viscosity_Ns_per_m);
}

bool usable(const GuidePlan& guide)
{
  return guide.point_W.allFinite() && std::fabs(guide.normal_W.norm() - 1.0) < unitRounding &&
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
  const std::string gameRefusal = this->game.on ? refuse(this->game) : std::string();
  const std::pair<bool, std::string> rules[] = {
    { nonNegative(this->stiffness_N_per_m), "stiffness [N/m] must be a number that is not negative" },
    { nonNegative(this->damping_Ns_per_m), "damping [N s/m] must be a number that is not negative" },
    { this->stiffnessLimit_N_per_m >= 0.0, "largest stiffness [N/m] must be a number that is not negative" },
    { usable(this->passivity),
      "passivity: delay [ticks, at most 16], reserve and repay [K T] must be numbers that are not negative" },
    { usable(this->velocity), "velocity: resolution [m] and time constant [s] must not be negative, the window 1 to " +
                                std::to_string(VelocityHistory::capacity - 1) + " ticks" },
    { nonNegative(this->contact.radius_u), "radius [scene units] must be a number that is not negative" },
    { bounded(this->contact), "the work of a tick must be 1 to 1024 passes and 1 to 10000000 units of work" },
    { usable(this->contact.friction),
      "friction: the kinetic coefficient must be a number from 0 to the static one, which is at most 10" },
    { nonNegative(this->map.scale_u_per_m) && this->map.scale_u_per_m > 0.0,
      "scale [scene units per metre] must be a number above zero" },
    { this->map.offset_W.allFinite() && std::fabs(this->map.q_WD.norm() - 1.0) < unitRounding,
      "the device's place in the scene must be finite and its rotation a unit quaternion" },
    { nonNegative(this->sceneBlend_s), "scene blend time [s] must be a number that is not negative" },
    { usable(this->walls),
      "held walls: period [s], step [m] and viscosity [N s/m] must be numbers that are not negative" },
    { usable(this->guide), "guide: the point must be finite, the normal a unit vector, stiffness [N/m], limit [N] and "
                           "ramp [s] not negative" },
    { gameRefusal.empty(), gameRefusal },
    { usable(this->safety), "safety limits [N, N/s, s] must be numbers that are not negative" },
  };
  const auto broken = std::find_if(std::begin(rules), std::end(rules), [](const auto& rule) { return !rule.first; });
  return broken == std::end(rules) ? std::string() : broken->second;
}

} // namespace palpate
