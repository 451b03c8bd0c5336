// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "haptics/geometry/scene/Scene.h"
#include "haptics/labyrinth/Labyrinth.h"
#include "haptics/labyrinth/LabyrinthButtons.h"
#include "haptics/tick/base/HapticState.h"

namespace palpate
{

class HapticSession;

/// A labyrinth that can be played, and its walls.
struct LabyrinthOnOffer
{
  Labyrinth labyrinth;
  std::shared_ptr<const Scene> walls;
};

/// The newest event, for a person who plays without a screen.
enum class LabyrinthNews : std::uint8_t
{
  None,
  Chosen, ///< and the button that chose it, or the dead-man, must be held now
  Leads,  ///< the hand is brought to the start
  LetGo,  ///< it is on its own
  Arrived,
  GaveUp,
  Fault, ///< no force until something is chosen again
  End,
};

/// Labyrinths on a running session, played from the device alone. A button chooses, holding the dead-man or that button
/// starts, letting go or another button gives up. The next labyrinth begins once no force is left on the hand. No
/// clock: time is the tick's.
class LabyrinthHost
{
public:
  /// Session and labyrinths must outlive the host. Nobody has engaged the session yet, and there is something to play.
  LabyrinthHost(HapticSession& session, const std::vector<LabyrinthOnOffer>& mazes, const DeadMan& deadMan);

  /// To be called often, at least once in 50 ms: reads the newest state of the session, and returns the event since the
  /// last call.
  [[nodiscard]] LabyrinthNews look();

  /// Of the labyrinth chosen last; null before.
  [[nodiscard]] const Labyrinth* chosen() const noexcept;
  /// Of exploring it, until now or until the exit [s].
  [[nodiscard]] double time_s() const noexcept { return this->gameTime_s_; }
  /// The controls that must be held for that one. Needs one.
  [[nodiscard]] DeadMan held() const noexcept { return this->menu_.heldFor(this->chosen_); }

private:
  [[nodiscard]] LabyrinthNews obey(const LabyrinthCall& call, const HapticState& state);
  [[nodiscard]] LabyrinthNews follow(const HapticState& state);
  void begin();
  void end();

  HapticSession& session_;
  const std::vector<LabyrinthOnOffer>& mazes_;
  LabyrinthMenu menu_;
  int chosen_ = 0;       ///< from 1 on
  bool waiting_ = false; ///< the one chosen begins when no force is left
  bool on_ = false;
  GamePhase phase_ = GamePhase::Off;
  double seen_s_ = 0.0, gameTime_s_ = 0.0;
};

} // namespace palpate
