// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "devices/simulated/SimulatedDevice.h"
#include "devices/simulated/labyrinth/BlindHand.h"
#include "devices/simulated/labyrinth/LabyrinthRun.h"
#include "haptics/session/LabyrinthHost.h"

namespace palpate
{

/// A simulated player of the labyrinths on offer, one after another to the end, with the means of a person: the
/// buttons, the handle's position and the force on it. A player who has been everywhere gives up. Deterministic.
class LabyrinthPlayer
{
public:
  /// The arguments must outlive it. `deadMan`: the one of the LabyrinthHost.
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
  double since_s_ = 0.0; ///< time in this turn
  std::optional<BlindHand> hand_;
};

} // namespace palpate
