// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "devices/simulated/DeviceModels.h"
#include "devices/simulated/labyrinth/BlindHand.h"
#include "haptics/labyrinth/Labyrinth.h"
#include "haptics/tick/base/HapticState.h"

namespace palpate
{

/// Parameters of the run of a blind hand through a labyrinth.
struct LabyrinthRun
{
  DeviceModel device = *deviceModel("simulated-joystick");
  HandModel hand = *handModel("firm");
  double host_Hz = 1000.0;
  bool deviceHoldsWalls = false; ///< the device renders at most four walls itself; else the host computes the force
  double mostTime_s = 7200.0;    ///< of the virtual clock
  bool trace = false;
};

/// Parameters for exploring this labyrinth on the device, at that scale.
[[nodiscard]] BlindPlan blindPlan(const Labyrinth& labyrinth, const LabyrinthRun& run, const WorkspaceMap& map);

/// Position and force of the hand after a tick, with the handle at that position [m].
[[nodiscard]] Felt feltOf(const HapticState& state, const Vec3& handle_D, const WorkspaceMap& map);

/// A moment of the run.
struct LabyrinthMoment
{
  double time_s = 0.0;
  Vec3 hand_W = Vec3::Zero();     ///< [u]
  Vec3 location_W = Vec3::Zero(); ///< of the disc [u]
  double force_N = 0.0;
};

/// The result of a run.
struct LabyrinthOutcome
{
  std::string problem;   ///< empty: the hand arrived; else one sentence
  bool explored = false; ///< the hand was released at the start; else the other members are zero
  double lead_s = 0.0;   ///< time to bring the hand to the start
  double time_s = 0.0;   ///< from there to the exit
  double way_u = 0.0;    ///< path length of the disc
  std::size_t places = 0;
  double peakForce_N = 0.0;
  std::vector<LabyrinthMoment> trace; ///< one every 10 ms at most
};

/// Empty, or one sentence with the numbers why this labyrinth cannot be played by this hand with this device: the
/// sentence of refuse(labyrinth); a hand without stiffness, which moves no handle; or an encoder with too large a step
/// D: the handle is known to D along each axis, so that it is surely within 0.15 corridors of a place only if sqrt(2) D
/// <= 0.15 corridors, the corridor fitted into the device's workspace. Friction and the largest force do not matter: a
/// hand pushes 2 N harder than friction, and even a wall that yields to the hand stops the virtual location.
[[nodiscard]] std::string refuse(const Labyrinth& labyrinth, const LabyrinthRun& run);

/// Plays the game with a BlindHand on a SimulatedDevice: the hand is brought to the start, released, and explores until
/// the exit is felt. The tick is computed at the host's rate; in virtual time, deterministic, bounded by mostTime_s.
[[nodiscard]] LabyrinthOutcome runBlind(const Labyrinth& labyrinth, const LabyrinthRun& run);

} // namespace palpate
