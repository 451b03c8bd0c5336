// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "haptics/labyrinth/LabyrinthGame.h"

namespace palpate
{

/// What a hand asks for with the buttons of its device.
enum class MazeWish : std::uint8_t
{
  None,
  Next,  ///< the next labyrinth: button 1
  Again, ///< start again: button 2
};

/// What buttons that went down (bit i: button i + 1) ask for in a phase: nothing from the lead on until the exit, so no
/// grip that slips ends a game. A button that holds the hand engaged (`deadMan`, same bits) chooses nothing.
[[nodiscard]] constexpr MazeWish wishOf(GamePhase phase, std::uint32_t wentDown, std::uint32_t deadMan) noexcept
{
  const bool plays = phase == GamePhase::Leads || phase == GamePhase::LetsGo || phase == GamePhase::Explores;
  const std::uint32_t free = plays ? 0u : wentDown & ~deadMan;
  return (free & 1u) != 0 ? MazeWish::Next : (free & 2u) != 0 ? MazeWish::Again : MazeWish::None;
}

} // namespace palpate
