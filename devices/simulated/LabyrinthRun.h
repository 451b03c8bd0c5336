// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "devices/simulated/BlindHand.h"
#include "devices/simulated/DeviceModels.h"
#include "haptics/labyrinth/Labyrinth.h"
#include "haptics/tick/HapticState.h"

namespace palpate
{

/// How a blind hand is sent through a labyrinth.
struct LabyrinthRun
{
  DeviceModel device = *deviceModel("simulated-joystick");
  HandModel hand = *handModel("firm");
  double host_Hz = 1000.0;
  bool deviceHoldsWalls =
    false;                    ///< the device closes at most four walls in its own loop; else the host closes the force
  double mostTime_s = 7200.0; ///< of the virtual clock
  bool trace = false;
};

/// How that hand explores this labyrinth on the device, at that scale.
[[nodiscard]] BlindPlan blindPlan(const Labyrinth& labyrinth, const LabyrinthRun& run, const WorkspaceMap& map);

/// What it feels after a tick, with the handle at that place [m].
[[nodiscard]] Felt feltOf(const HapticState& state, const Vec3& handle_D, const WorkspaceMap& map);

/// A moment of the way.
struct LabyrinthMoment
{
  double time_s = 0.0;
  Vec3 hand_W = Vec3::Zero();     ///< [u]
  Vec3 location_W = Vec3::Zero(); ///< of the disc [u]
  double force_N = 0.0;
};

/// How it went.
struct LabyrinthOutcome
{
  std::string problem;   ///< empty: it arrived; else one sentence
  bool explored = false; ///< it was let go at the start; else all that follows is zero
  double lead_s = 0.0;   ///< it took to bring the hand to the start
  double time_s = 0.0;   ///< from there to the exit
  double way_u = 0.0;    ///< of the disc
  std::size_t places = 0;
  double peakForce_N = 0.0;
  std::vector<LabyrinthMoment> trace; ///< one every 10 ms at most
};

/// Empty, or one sentence with the numbers why this labyrinth cannot be played by this hand with this device: what
/// refuse(labyrinth) says; a hand without stiffness leads nothing; and where the encoder shows a step D, the handle is
/// known to D along each axis, so that it can be told to be within 0.15 corridors of a place only if
/// sqrt(2) D <= 0.15 corridors, the corridor fitted into the device's workspace. Friction and the largest force decide
/// nothing: a hand pushes 2 N harder than friction, and a wall that gives way holds the location all the same.
[[nodiscard]] std::string refuse(const Labyrinth& labyrinth, const LabyrinthRun& run);

/// Plays the game with a BlindHand on a SimulatedDevice: brought to the start, let go, on its own until the exit is
/// felt. The tick is computed at the host's rate; in virtual time, deterministic, bounded by mostTime_s.
[[nodiscard]] LabyrinthOutcome runBlind(const Labyrinth& labyrinth, const LabyrinthRun& run);

} // namespace palpate
