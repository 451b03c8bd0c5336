// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "haptics/core/Types.h"

namespace palpate
{

struct Labyrinth;

/// The phase of a labyrinth game.
enum class GamePhase : std::uint8_t
{
  Off,      ///< nobody plays
  Waits,    ///< for a hand that holds the device and asks for force
  Leads,    ///< the hand is brought to the start; no wall is felt
  LetsGo,   ///< the lead fades out, the walls fade in
  Explores, ///< the hand is on its own, and the time runs
  Arrived,  ///< at the exit: the hand is shaken
  Rests,    ///< the game is over; let go and grip again, or ask, for another one
};

[[nodiscard]] const char* name(GamePhase phase) noexcept;

/// How a labyrinth is played. Part of every recording.
struct GamePlan
{
  bool on = false;
  Vec3 start_W = Vec3::Zero(), exit_W = Vec3::Zero(); ///< [u]
  double exitReach_u = 0.0;                           ///< arrived this near to the exit
  double lead_m_per_s = 0.08;                         ///< of the guiding spring
  double stiffness_N_per_m = 200.0;                   ///< of the spring between the two
  double damping_Ns_per_m = 8.0; ///< of the hand while it is led: no spring makes it faster than force / damping
  double largest_N = 1.0;        ///< of the spring: who holds back harder is not moved
  double near_m = 2e-3;          ///< the hand is let go this near to the start
  double fade_s = 0.3;
  double shake_N = 1.0; ///< amplitude at the exit, in the plane
  double shake_Hz = 25.0;
  double shake_s = 1.0;

  /// No hand is led faster.
  static constexpr double fastest_m_per_s = 0.2;

  friend bool operator==(const GamePlan&, const GamePlan&) = default;
};

/// The plan of a labyrinth that refuse() has nothing against.
[[nodiscard]] GamePlan gameOf(const Labyrinth& labyrinth);

/// Empty, or one sentence that names the refused number: a speed, a force or a duration beyond the limits for a hand.
[[nodiscard]] std::string refuse(const GamePlan& plan);

/// All that a game remembers from tick to tick.
struct GameState
{
  GamePhase phase = GamePhase::Off;
  Vec3 drawn_D = Vec3::Zero(); ///< extension of the guiding spring [m]
  bool creeps = false;         ///< it has been at the start, and pulls beyond
  double phase_s = 0.0;        ///< since this phase began
  double time_s = 0.0;         ///< of exploring
};

/// Input of the game in a tick.
struct GameTick
{
  Vec3 hand_D = Vec3::Zero();     ///< [m]
  Vec3 velocity_D = Vec3::Zero(); ///< [m/s]
  Vec3 start_D = Vec3::Zero();    ///< [m]
  double stiffness_N_per_m = 0.0; ///< the largest that the device can hold
  bool engaged = false;           ///< somebody holds the device and has asked for force
  bool again = false;             ///< another game is asked for
  double dt_s = 1e-3;
  double loop_s = 1e-3; ///< between two forces: dt_s, or the period of a device that closes springs itself
};

/// Output of the game for a tick.
struct GameForce
{
  Vec3 lead_D = Vec3::Zero();    ///< [N]
  bool contact = true;           ///< the walls hold the hand
  double walls = 1.0;            ///< share of their force that acts
  double spring_N_per_m = 0.0;   ///< the lead as a spring to GameState::drawn_D
  double spring_N = 0.0;         ///< up to that force
  double damping_Ns_per_m = 0.0; ///< and a damper, for a device that closes them itself
  bool seat = false;             ///< contact begins in this tick, at the start
};

/// The first half of a tick, before contact. Pure but for the state; real-time safe.
[[nodiscard]] GameForce lead(const GamePlan& plan, const GameTick& tick, GameState& state) noexcept;

/// The second half, after contact: whether the virtual location is at the exit, and the force that says so [N, in D].
[[nodiscard]] Vec3 arrive(const GamePlan& plan, const Vec3& location_W, double dt_s, GameState& state) noexcept;

} // namespace palpate
