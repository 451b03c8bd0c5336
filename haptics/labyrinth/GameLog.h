// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <utility>

#include "haptics/labyrinth/LabyrinthButtons.h"
#include "haptics/labyrinth/WayTrace.h"

namespace palpate
{

/// The record of a game so far, for an occasional reader: the path of the proxy, and the labyrinth that the device's
/// buttons asked for.
class GameLog
{
public:
  /// The state of the game at one reading.
  struct Look
  {
    std::uint64_t tick = 0; ///< 0: nothing has been computed yet
    GamePhase phase = GamePhase::Off;
    double gameTime_s = 0.0;   ///< of exploring
    std::uint32_t buttons = 0; ///< that are down
    Vec3 proxy_W = Vec3::Zero();
  };

  /// Another labyrinth: its path begins anew, with points no nearer than that [u].
  void begin(double apart_u);
  /// `deadMan`: buttons that choose nothing. Time that goes back is another game.
  void look(const Look& now, std::uint32_t deadMan);

  [[nodiscard]] const WayTrace& trace() const noexcept { return this->trace_; }
  /// Asked for since the last call, from 1 on; 0: none.
  [[nodiscard]] int takeWish() noexcept { return std::exchange(this->wish_, 0); }

private:
  double apart_u_ = 1.0;
  WayTrace trace_;
  double time_s_ = 0.0;
  std::uint32_t buttons_ = ~0u; ///< at the last reading; a button down at the first reading was not pressed
  int wish_ = 0;
};

} // namespace palpate
