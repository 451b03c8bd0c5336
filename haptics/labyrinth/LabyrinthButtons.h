// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "haptics/labyrinth/LabyrinthGame.h"
#include "haptics/safety/DeadMan.h"

namespace palpate
{

/// Whether a hand plays: from the lead on until the exit.
[[nodiscard]] constexpr bool isPlayed(GamePhase phase) noexcept
{
  return phase == GamePhase::Leads || phase == GamePhase::LetsGo || phase == GamePhase::Explores;
}

/// The labyrinth, from 1 on, that buttons which went down (bit i: button i + 1) ask for: button n for labyrinth n, the
/// lowest of several. While a labyrinth is played, nothing: no grip that slips ends a game. A button that holds the
/// hand engaged (`deadMan`, same bits) chooses nothing.
[[nodiscard]] constexpr std::optional<int> mazeOf(
  GamePhase phase, std::uint32_t wentDown, std::uint32_t deadMan) noexcept
{
  const std::uint32_t free = isPlayed(phase) ? 0u : wentDown & ~deadMan;
  for (int button = 1; button <= 32; ++button)
  {
    if ((free >> (button - 1) & 1u) != 0)
    {
      return button;
    }
  }
  return std::nullopt;
}

/// Requests of a person who has only the device.
struct LabyrinthCall
{
  enum class Kind : std::uint8_t
  {
    None,
    Play,
    GiveUp,
    End,
  };

  Kind kind = Kind::None;
  int maze = 0; ///< to play, from 1 on
};

/// Buttons 1 to `mazes` choose, the next one ends. The dead-man switch is `deadMan`, or, without one, the
/// button that chose. Letting go of that button gives the game up, and so does holding any other button than the
/// dead-man's for a second.
class LabyrinthMenu
{
public:
  static constexpr double giveUp_s = 1.0;

  LabyrinthMenu(int mazes, const DeadMan& deadMan) noexcept : mazes_(mazes), deadMan_(deadMan) {}

  /// To be called with the newest buttons, `dt_s` after the last time. A button down at first was not pressed.
  [[nodiscard]] LabyrinthCall look(GamePhase phase, std::uint32_t buttons, double dt_s) noexcept;

  /// The dead-man switch while this labyrinth, from 1 on, is played.
  [[nodiscard]] DeadMan heldFor(int maze) const noexcept;
  [[nodiscard]] bool chooserHolds() const noexcept { return this->deadMan_ == DeadMan{}; }

private:
  int mazes_;
  DeadMan deadMan_;
  std::uint32_t down_ = ~0u;
  double others_s_ = 0.0; ///< for which another button has been held in a game
};

} // namespace palpate
