// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/labyrinth/GameLog.h"

namespace palpate
{

void GameLog::begin(double apart_u)
{
  this->apart_u_ = apart_u;
  this->trace_ = WayTrace(apart_u);
}

void GameLog::look(const Look& now, std::uint32_t deadMan)
{
  const std::uint32_t down = now.tick > 0 ? now.buttons : ~0u;
  const std::uint32_t wentDown = down & ~std::exchange(this->buttons_, down);
  this->wish_ = mazeOf(now.phase, wentDown, deadMan).value_or(this->wish_);
  const double before_s = std::exchange(this->time_s_, now.gameTime_s);
  if (now.gameTime_s < before_s)
  {
    this->trace_ = WayTrace(this->apart_u_);
  }
  if (now.gameTime_s > before_s)
  {
    this->trace_.add(now.proxy_W);
  }
}

} // namespace palpate
