// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "haptics/labyrinth/LabyrinthButtons.h"
#include "haptics/tick/ForceRenderer.h"

namespace palpate
{
namespace
{

constexpr std::uint32_t first = 1u << 0, second = 1u << 1, third = 1u << 2, fourth = 1u << 3;
constexpr GamePhase idleOrFinished[] = { GamePhase::Off, GamePhase::Waits, GamePhase::Arrived, GamePhase::Rests };
constexpr GamePhase playing[] = { GamePhase::Leads, GamePhase::LetsGo, GamePhase::Explores };
constexpr double look_s = 0.01;

TEST(LabyrinthButtons, ButtonNAsksForLabyrinthNWhileNobodyPlays)
{
  for (const GamePhase phase : idleOrFinished)
  {
    for (int n = 1; n <= 32; ++n)
    {
      EXPECT_EQ(mazeOf(phase, 1u << (n - 1), 0), n) << name(phase);
    }
    EXPECT_EQ(mazeOf(phase, second | third, 0), 2) << name(phase);
    EXPECT_EQ(mazeOf(phase, 0, 0), std::nullopt) << name(phase);
  }
}

TEST(LabyrinthButtons, NothingEndsAGameThatIsPlayed)
{
  for (const GamePhase phase : playing)
  {
    EXPECT_EQ(mazeOf(phase, ~0u, 0), std::nullopt) << name(phase);
  }
}

TEST(LabyrinthButtons, ButtonOfTheDeadManChoosesNothingAndTheOtherStillDoes)
{
  for (const GamePhase phase : idleOrFinished)
  {
    EXPECT_EQ(mazeOf(phase, first, first), std::nullopt) << name(phase);
    EXPECT_EQ(mazeOf(phase, first | second, first), 2) << name(phase);
    EXPECT_EQ(mazeOf(phase, first | second, first | second), std::nullopt) << name(phase);
    EXPECT_EQ(mazeOf(phase, first, third), 1) << name(phase);
  }
}

TEST(LabyrinthButtons, StateOfATickHasTheButtonsOfItsSample)
{
  TickInput input;
  input.sample.buttons = first | third;
  const HapticParameters parameters;
  RendererState state;
  EXPECT_EQ(renderTick(input, parameters, state).state.buttons, first | third);
}

/// The menu's answer to buttons that are pressed from nothing.
LabyrinthCall pressed(LabyrinthMenu menu, GamePhase phase, std::uint32_t buttons)
{
  static_cast<void>(menu.look(phase, 0, look_s));
  return menu.look(phase, buttons, look_s);
}

TEST(LabyrinthMenu, ChoosesByNumberEndsWithTheNextOneAndKnowsNoOther)
{
  const LabyrinthMenu menu(2, {});
  EXPECT_EQ(pressed(menu, GamePhase::Off, second).kind, LabyrinthCall::Kind::Play);
  EXPECT_EQ(pressed(menu, GamePhase::Off, second).maze, 2);
  EXPECT_EQ(pressed(menu, GamePhase::Off, third).kind, LabyrinthCall::Kind::End);
  EXPECT_EQ(pressed(menu, GamePhase::Off, fourth).kind, LabyrinthCall::Kind::None);
}

TEST(LabyrinthMenu, AButtonThatWasDownFromTheStartAndOneThatIsKeptDownWerePressedByNobody)
{
  LabyrinthMenu menu(2, {});
  EXPECT_EQ(menu.look(GamePhase::Off, first, look_s).kind, LabyrinthCall::Kind::None);
  EXPECT_EQ(menu.look(GamePhase::Off, first, look_s).kind, LabyrinthCall::Kind::None);
  EXPECT_EQ(menu.look(GamePhase::Off, 0, look_s).kind, LabyrinthCall::Kind::None);
  EXPECT_EQ(menu.look(GamePhase::Off, first, look_s).kind, LabyrinthCall::Kind::Play);
  EXPECT_EQ(menu.look(GamePhase::Off, first, look_s).kind, LabyrinthCall::Kind::None);
}

TEST(LabyrinthMenu, WhatChoseMustBeHeldUnlessSomethingElseIs)
{
  EXPECT_EQ(LabyrinthMenu(4, {}).heldFor(3), (DeadMan{ third, false }));
  EXPECT_EQ(LabyrinthMenu(4, { second, false }).heldFor(3), (DeadMan{ second, false }));
  EXPECT_EQ(LabyrinthMenu(4, { 0, true }).heldFor(3), (DeadMan{ 0, true }));
}

TEST(LabyrinthMenu, AnotherButtonGivesUpOnceItHasBeenHeldForASecondOnEnd)
{
  const DeadMan deadMan{ first, false };
  for (const GamePhase phase : playing)
  {
    LabyrinthMenu menu(4, deadMan);
    const int ticks = static_cast<int>(LabyrinthMenu::giveUp_s / look_s);
    for (int tick = 1; tick < ticks; ++tick)
    {
      ASSERT_EQ(menu.look(phase, first | second, look_s).kind, LabyrinthCall::Kind::None) << tick;
    }
    ASSERT_EQ(menu.look(phase, first, look_s).kind, LabyrinthCall::Kind::None); // slipped: it begins anew
    int held = 1;
    while (held < 2 * ticks && menu.look(phase, first | fourth, look_s).kind != LabyrinthCall::Kind::GiveUp)
    {
      ++held;
    }
    EXPECT_NEAR(held, ticks, 1) << name(phase); // to the rounding of a sum
  }
}

TEST(LabyrinthMenu, WhereWhatChoseIsHeldNoOtherButtonGivesUp)
{
  LabyrinthMenu menu(4, {});
  for (int tick = 0; tick < 1000; ++tick)
  {
    ASSERT_EQ(menu.look(GamePhase::Explores, first | second, look_s).kind, LabyrinthCall::Kind::None);
  }
}

} // namespace
} // namespace palpate
