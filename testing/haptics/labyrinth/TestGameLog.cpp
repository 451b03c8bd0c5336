// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "haptics/labyrinth/GameLog.h"

namespace palpate
{
namespace
{

GameLog::Look exploring(double time_s, double x_u)
{
  return { 100, GamePhase::Explores, time_s, 0, Vec3(x_u, 0, 0) };
}

TEST(GameLog, KeepsTheWayWhileTimeGoesOnAndBeginsAnewWithEachGame)
{
  GameLog log;
  log.begin(0.5);
  for (int i = 1; i <= 4; ++i)
  {
    log.look(exploring(0.1 * i, i), 0);
  }
  log.look(exploring(0.4, 9), 0); // the time stands still: nobody explores
  ASSERT_EQ(log.trace().points_W().size(), 4U);
  EXPECT_EQ(log.trace().points_W().back().x(), 4.0);
  log.look(exploring(0.1, 7), 0); // it went back: another game
  EXPECT_TRUE(log.trace().points_W().empty());
  EXPECT_EQ(log.trace().apart_u(), 0.5);
  log.look(exploring(0.2, 8), 0);
  EXPECT_EQ(log.trace().points_W().size(), 1U);
}

TEST(GameLog, WishesAreButtonsThatGoDownAndAreTakenOnce)
{
  GameLog log;
  log.look({ 0, GamePhase::Off, 0, 0b1 }, 0);
  log.look({ 1, GamePhase::Off, 0, 0b1 }, 0);
  EXPECT_EQ(log.takeWish(), 0) << "what is down at first was not pressed";
  log.look({ 2, GamePhase::Off, 0, 0b101 }, 0);
  log.look({ 3, GamePhase::Off, 0, 0b000 }, 0);
  EXPECT_EQ(log.takeWish(), 3);
  EXPECT_EQ(log.takeWish(), 0);
  log.look({ 4, GamePhase::Off, 0, 0b010 }, 0b010);
  EXPECT_EQ(log.takeWish(), 0) << "it is the dead-man's";
  log.look({ 5, GamePhase::Explores, 0.1, 0b110 }, 0);
  EXPECT_EQ(log.takeWish(), 0) << "not in a game";
}

} // namespace
} // namespace palpate
