// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/labyrinth/LabyrinthGame.h"

#include <algorithm>
#include <cmath>

#include "haptics/labyrinth/Labyrinth.h"
#include "haptics/safety/ForceLimits.h"

namespace palpate
{
namespace
{

constexpr double creep_m_per_s = 0.01; // of the draw beyond the start, for a hand that friction holds short of it
constexpr double carefully = 0.625;    // of the fastest speed; the rest is for the delay of the velocity estimate
constexpr double lightest_kg = 0.02;   // a damper that acts once a period never turns a mass like this round

void enter(GamePhase phase, GameState& state) noexcept
{
  state.phase = phase;
  state.phase_s = 0.0;
}

/// The plan with spring and damper limited to the rate of the loop.
GamePlan atRate(GamePlan plan, const GameTick& tick) noexcept
{
  plan.stiffness_N_per_m = std::min(plan.stiffness_N_per_m, tick.stiffness_N_per_m);
  plan.damping_Ns_per_m = std::min(plan.damping_Ns_per_m, lightest_kg / tick.loop_s);
  plan.largest_N = std::min(plan.largest_N, carefully * GamePlan::fastest_m_per_s * plan.damping_Ns_per_m);
  return plan;
}

/// The draw goes straight to the start. From then on the draw creeps along the way that the hand still lacks, until the
/// hand is there. The draw is never further from the hand than the spring takes for its largest force.
void draw(const GamePlan& plan, const GameTick& tick, GameState& state) noexcept
{
  const Vec3 way_D = tick.start_D - state.drawn_D, missing_D = tick.start_D - tick.hand_D;
  state.creeps = state.creeps || way_D.norm() <= plan.lead_m_per_s * tick.dt_s;
  state.drawn_D += state.creeps ? clampMagnitude(missing_D, creep_m_per_s * tick.dt_s)
                                : clampMagnitude(way_D, plan.lead_m_per_s * tick.dt_s);
  const double reach_m = plan.stiffness_N_per_m > 0.0 ? plan.largest_N / plan.stiffness_N_per_m : 0.0;
  state.drawn_D = tick.hand_D + clampMagnitude(state.drawn_D - tick.hand_D, reach_m);
}

/// Who holds the device and asked for force is led; who lets go waits.
void begin(const GamePlan& plan, const GameTick& tick, GameState& state) noexcept
{
  if (!plan.on)
  {
    state = {};
    return;
  }
  if (!tick.engaged)
  {
    enter(GamePhase::Waits, state);
    return;
  }
  state.phase_s += tick.dt_s;
  if (state.phase <= GamePhase::Waits || tick.again)
  {
    state = {};
    enter(GamePhase::Leads, state);
    state.drawn_D = tick.hand_D;
  }
}

/// Parabolas in place of a sine: smooth, odd, and without a library's rounding.
double wave(double turns) noexcept
{
  const double t = turns - static_cast<double>(static_cast<std::int64_t>(turns));
  return t < 0.5 ? 16.0 * t * (0.5 - t) : -16.0 * (t - 0.5) * (1.0 - t);
}

/// Up and down again within a tenth of the duration each.
double envelope(double share) noexcept
{
  constexpr double edge = 0.1;
  return smoothstep(std::min(share, 1.0 - share) / edge);
}

} // namespace

const char* name(GamePhase phase) noexcept
{
  switch (phase)
  {
    case GamePhase::Off:
      return "off";
    case GamePhase::Waits:
      return "waits";
    case GamePhase::Leads:
      return "leads";
    case GamePhase::LetsGo:
      return "lets go";
    case GamePhase::Explores:
      return "explores";
    case GamePhase::Arrived:
      return "arrived";
    case GamePhase::Rests:
      return "rests";
  }
  return "unknown";
}

GamePlan gameOf(const Labyrinth& labyrinth)
{
  GamePlan plan;
  plan.on = true;
  plan.start_W = { labyrinth.start_W->x(), labyrinth.start_W->y(), 0.0 };
  plan.exit_W = { labyrinth.exit_W->x(), labyrinth.exit_W->y(), 0.0 };
  plan.exitReach_u = labyrinth.exitReach_u();
  return plan;
}

std::string refuse(const GamePlan& plan)
{
  const auto within = [](double value, double most) { return value > 0.0 && value <= most; };
  if (!plan.start_W.allFinite() || !plan.exit_W.allFinite() || !within(plan.exitReach_u, 1e300))
  {
    return "labyrinth: start and exit [u] must be finite, the exit's reach above zero";
  }
  if (!within(plan.lead_m_per_s, 0.5 * GamePlan::fastest_m_per_s))
  {
    return "labyrinth: the guiding speed must be above 0 and at most 0.1 m/s";
  }
  if (!within(plan.stiffness_N_per_m, 1000.0) || !within(plan.largest_N, 5.0) || !within(plan.near_m, 0.02) ||
      !within(plan.damping_Ns_per_m, 20.0) || !within(plan.fade_s, 10.0))
  {
    return "labyrinth: the guiding spring is limited to 1000 N/m, 5 N and 20 N s/m, the release to 20 mm and 10 s";
  }
  if (!within(plan.shake_N, 3.0) || !within(plan.shake_Hz, 100.0) || !within(plan.shake_s, 5.0))
  {
    return "labyrinth: the vibration at the exit is limited to 3 N, 100 Hz and 5 s";
  }
  return {};
}

GameForce lead(const GamePlan& wanted, const GameTick& tick, GameState& state) noexcept
{
  begin(wanted, tick, state);
  GameForce force;
  if (state.phase != GamePhase::Leads && state.phase != GamePhase::LetsGo)
  {
    return force;
  }
  const GamePlan plan = atRate(wanted, tick);
  if (state.phase == GamePhase::Leads)
  {
    draw(plan, tick, state);
    force.seat = (tick.hand_D - tick.start_D).norm() <= plan.near_m;
    if (force.seat)
    {
      enter(GamePhase::LetsGo, state);
    }
  }
  force.contact = state.phase != GamePhase::Leads;
  force.walls = force.contact ? smoothstep(state.phase_s / plan.fade_s) : 0.0;
  const double share = 1.0 - force.walls;
  force.spring_N_per_m = share * plan.stiffness_N_per_m;
  force.spring_N = share * plan.largest_N;
  force.damping_Ns_per_m = share * plan.damping_Ns_per_m;
  force.lead_D = clampMagnitude(force.spring_N_per_m * (state.drawn_D - tick.hand_D), force.spring_N) -
                 force.damping_Ns_per_m * tick.velocity_D;
  if (force.walls >= 1.0)
  {
    enter(GamePhase::Explores, state);
  }
  return force;
}

Vec3 arrive(const GamePlan& plan, const Vec3& location_W, double dt_s, GameState& state) noexcept
{
  if (state.phase == GamePhase::Explores)
  {
    state.time_s += dt_s;
    if ((location_W - plan.exit_W).norm() <= plan.exitReach_u)
    {
      enter(GamePhase::Arrived, state);
    }
  }
  if (state.phase != GamePhase::Arrived)
  {
    return Vec3::Zero();
  }
  if (state.phase_s >= plan.shake_s)
  {
    enter(GamePhase::Rests, state);
    return Vec3::Zero();
  }
  return { plan.shake_N * envelope(state.phase_s / plan.shake_s) * wave(plan.shake_Hz * state.phase_s), 0.0, 0.0 };
}

} // namespace palpate
