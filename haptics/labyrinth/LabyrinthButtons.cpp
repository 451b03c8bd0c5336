// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/labyrinth/LabyrinthButtons.h"

#include <utility>

namespace palpate
{

LabyrinthCall LabyrinthMenu::look(GamePhase phase, std::uint32_t buttons, double dt_s) noexcept
{
  const std::uint32_t wentDown = buttons & ~std::exchange(this->down_, buttons);
  const bool others = isPlayed(phase) && !this->chooserHolds() && (buttons & ~this->deadMan_.buttons) != 0;
  this->others_s_ = others ? this->others_s_ + dt_s : 0.0;
  if (this->others_s_ >= giveUp_s)
  {
    this->others_s_ = 0.0;
    return { LabyrinthCall::Kind::GiveUp };
  }
  const int button = mazeOf(phase, wentDown, this->deadMan_.buttons).value_or(0);
  if (button == 0 || button > this->mazes_ + 1)
  {
    return {};
  }
  return button > this->mazes_ ? LabyrinthCall{ LabyrinthCall::Kind::End }
                               : LabyrinthCall{ LabyrinthCall::Kind::Play, button };
}

DeadMan LabyrinthMenu::heldFor(int maze) const noexcept
{
  return this->chooserHolds() ? DeadMan{ 1u << (maze - 1), false } : this->deadMan_;
}

} // namespace palpate
