// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "haptics/labyrinth/MazeButtons.h"
#include "haptics/session/ForceRenderer.h"

namespace palpate
{
namespace
{

constexpr std::uint32_t first = 1u << 0, second = 1u << 1, third = 1u << 2;
constexpr GamePhase idleOrFinished[] = { GamePhase::Off, GamePhase::Waits, GamePhase::Arrived, GamePhase::Rests };
constexpr GamePhase playing[] = { GamePhase::Leads, GamePhase::LetsGo, GamePhase::Explores };

TEST(MazeButtons, FirstAsksForTheNextAndSecondToStartAgainWhileNobodyPlays)
{
  for (const GamePhase phase : idleOrFinished)
  {
    EXPECT_EQ(wishOf(phase, first, 0), MazeWish::Next) << name(phase);
    EXPECT_EQ(wishOf(phase, second, 0), MazeWish::Again) << name(phase);
    EXPECT_EQ(wishOf(phase, first | second, 0), MazeWish::Next) << name(phase);
  }
}

TEST(MazeButtons, NoOtherButtonAsksForAnything)
{
  for (const GamePhase phase : idleOrFinished)
  {
    EXPECT_EQ(wishOf(phase, 0, 0), MazeWish::None) << name(phase);
    EXPECT_EQ(wishOf(phase, ~(first | second), 0), MazeWish::None) << name(phase);
  }
}

TEST(MazeButtons, NothingEndsAGameThatIsPlayed)
{
  for (const GamePhase phase : playing)
  {
    EXPECT_EQ(wishOf(phase, ~0u, 0), MazeWish::None) << name(phase);
  }
}

TEST(MazeButtons, ButtonOfTheDeadManChoosesNothingAndTheOtherStillDoes)
{
  for (const GamePhase phase : idleOrFinished)
  {
    EXPECT_EQ(wishOf(phase, first, first), MazeWish::None) << name(phase);
    EXPECT_EQ(wishOf(phase, first | second, first), MazeWish::Again) << name(phase);
    EXPECT_EQ(wishOf(phase, first | second, first | second), MazeWish::None) << name(phase);
    EXPECT_EQ(wishOf(phase, first, third), MazeWish::Next) << name(phase);
  }
}

TEST(MazeButtons, StateOfATickHasTheButtonsOfItsSample)
{
  TickInput input;
  input.sample.buttons = first | third;
  const HapticParameters parameters;
  RendererState state;
  EXPECT_EQ(renderTick(input, parameters, state).state.buttons, first | third);
}

} // namespace
} // namespace palpate
