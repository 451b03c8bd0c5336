// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "devices/simulated/BlindHand.h"
#include "devices/simulated/LabyrinthRun.h"
#include "devices/simulated/SimulatedDevice.h"
#include "haptics/session/LabyrinthHost.h"

namespace palpate
{

/// A simulated person who plays the labyrinths on offer one after another, and then ends, with what a person at the
/// device has: its buttons, where the handle is and how it is pushed. Who has been everywhere gives up. Deterministic.
class LabyrinthPlayer
{
public:
  /// What is handed in must outlive it. `deadMan`: as the LabyrinthHost was told.
  LabyrinthPlayer(SimulatedDevice& device, const LabyrinthRun& run, const std::vector<LabyrinthOnOffer>& mazes,
    const DeadMan& deadMan);

  /// After each tick: presses buttons and leads the handle for the next.
  void look(const HapticState& state, const WorkspaceMap& map);

private:
  void press(const HapticState& state);
  void goOn();
  [[nodiscard]] Vec3 explore(const HapticState& state, const Vec3& handle_D, const WorkspaceMap& map);

  SimulatedDevice& device_;
  const LabyrinthRun& run_;
  const std::vector<LabyrinthOnOffer>& mazes_;
  LabyrinthMenu menu_;
  std::size_t turn_ = 0; ///< the labyrinth that is played; behind the last one: the end
  bool begun_ = false, over_ = false;
  double since_s_ = 0.0; ///< of this turn
  std::optional<BlindHand> hand_;
};

} // namespace palpate
