// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "devices/simulated/labyrinth/LabyrinthPlayer.h"
#include "haptics/safety/ForceLimits.h"
#include "haptics/session/HapticSession.h"
#include "haptics/session/LabyrinthHost.h"

namespace palpate
{
namespace
{

using testing::ElementsAre;

/// A closed corridor of width 1.
LabyrinthOnOffer corridor(const std::string& name, double length_u)
{
  LabyrinthOnOffer maze;
  maze.labyrinth.name = name;
  maze.labyrinth.curves = { { { 0, 0 }, { length_u, 0 }, { length_u, 1 }, { 0, 1 } },
    { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 } } };
  maze.labyrinth.start_W = Eigen::Vector2d(0.5, 0.5);
  maze.labyrinth.exit_W = Eigen::Vector2d(length_u - 0.5, 0.5);
  maze.walls = SceneBuilder().build({ wallsOf(maze.labyrinth) }).scene;
  return maze;
}

/// A session on a simulated joystick whose buttons are pressed and whose handle is led.
class Table
{
public:
  explicit Table(const DeadMan& deadMan = {})
    : mazes({ corridor("short", 4.0), corridor("long", 8.0) }), host(session, mazes, deadMan)
  {
    HandPath path;
    path.points_D = { Vec3::Zero() };
    auto made = std::make_unique<SimulatedDevice>(
      *deviceModel("simulated-joystick"), *handModel("firm"), path, SimulationOptions{});
    this->device = made.get();
    HapticParameters parameters;
    parameters.walls.hold = true;
    parameters.safety = SafetyLimits::forDevice(made->info());
    EXPECT_EQ(this->session.setParameters(parameters), "");
    SessionOptions options;
    options.virtualTime = true;
    options.engage = false;
    EXPECT_EQ(this->session.start(std::move(made), options), "");
  }

  /// Steps and looks until there is news, at most that long; a hand that is not led yields.
  LabyrinthNews until(double most_s = 20.0)
  {
    for (int tick = 0; tick < static_cast<int>(most_s * 1000.0); ++tick)
    {
      this->step();
      if (const LabyrinthNews news = this->host.look(); news != LabyrinthNews::None)
      {
        return news;
      }
    }
    return LabyrinthNews::None;
  }

  void step()
  {
    this->session.step(1);
    const HapticState& state = this->session.state();
    const Vec3 handle_D = this->session.parameters().map.toDevice(state.device_W.p);
    this->arm_D += this->goal_D ? clampMagnitude(*this->goal_D - this->arm_D, 1e-4) : Vec3(handle_D - this->arm_D);
    this->device->lead(this->arm_D);
    this->strongest_N = std::max(this->strongest_N, state.force_D.norm());
  }

  /// Nothing is pressed for a moment, then this.
  void press(std::uint32_t buttons)
  {
    this->device->press(0);
    EXPECT_EQ(this->until(0.1), LabyrinthNews::None);
    this->device->press(buttons);
  }

  /// The hand goes there, in scene units, at 0.1 m/s, and stays.
  void go(const Eigen::Vector2d& to_W)
  {
    this->goal_D = this->session.parameters().map.toDevice(Vec3(to_W.x(), to_W.y(), 0.0));
  }

  std::vector<LabyrinthOnOffer> mazes;
  HapticSession session;
  LabyrinthHost host;
  SimulatedDevice* device = nullptr;
  Vec3 arm_D = Vec3::Zero();
  std::optional<Vec3> goal_D; ///< nothing: the hand yields
  double strongest_N = 0.0;
};

TEST(LabyrinthHost, NothingPushesBeforeAButtonWasPressed)
{
  Table table;
  EXPECT_EQ(table.until(2.0), LabyrinthNews::None);
  EXPECT_EQ(table.strongest_N, 0.0);
  EXPECT_EQ(table.session.state().engage, EngageState::Safe);
}

TEST(LabyrinthHost, ButtonTwoKeptDownPlaysTheSecondLabyrinthFromTheLeadToTheExit)
{
  Table table;
  table.press(2);
  EXPECT_EQ(table.until(), LabyrinthNews::Chosen);
  EXPECT_EQ(table.host.chosen()->name, "long");
  EXPECT_EQ(table.host.held(), (DeadMan{ 2, false }));
  EXPECT_EQ(table.until(), LabyrinthNews::Leads);
  EXPECT_EQ(table.until(), LabyrinthNews::LetGo);
  EXPECT_EQ(table.until(1.0), LabyrinthNews::None);
  ASSERT_EQ(table.session.state().game, GamePhase::Explores);
  table.go(*table.mazes[1].labyrinth.exit_W);
  EXPECT_EQ(table.until(), LabyrinthNews::Arrived);
  EXPECT_GT(table.host.time_s(), 0.5); // of the second before it went
  EXPECT_EQ(table.until(3.0), LabyrinthNews::None);
  EXPECT_EQ(table.session.state().game, GamePhase::Off); // once it has been shaken
  EXPECT_EQ(table.session.state().force_D.norm(), 0.0);
}

TEST(LabyrinthHost, WhoLetsGoOfWhatChoseGivesUpAndNothingPushesAnyMore)
{
  for (const LabyrinthNews when : { LabyrinthNews::Leads, LabyrinthNews::LetGo })
  {
    Table table;
    table.press(1);
    while (table.until() != when)
    {
      ASSERT_LT(table.session.state().time_s, 30.0);
    }
    table.device->press(0);
    EXPECT_EQ(table.until(0.1), LabyrinthNews::GaveUp);
    EXPECT_EQ(table.until(0.2), LabyrinthNews::None);
    table.strongest_N = 0.0;
    table.press(0);
    EXPECT_EQ(table.strongest_N, 0.0);
    table.press(1); // and another game begins like the first
    EXPECT_EQ(table.until(), LabyrinthNews::Chosen);
    // Who was let go at the start is there already, and let go at once.
    EXPECT_EQ(table.until(), when);
  }
}

TEST(LabyrinthHost, WithADeadManOfItsOwnTheChooserIsOnlyTappedAndAnotherButtonHeldGivesUp)
{
  Table table({ 4, false });
  table.press(2);
  EXPECT_EQ(table.until(), LabyrinthNews::Chosen);
  EXPECT_EQ(table.until(1.0), LabyrinthNews::None); // nobody holds button 3
  EXPECT_EQ(table.strongest_N, 0.0);
  table.device->press(4);
  EXPECT_EQ(table.until(), LabyrinthNews::Leads);
  EXPECT_EQ(table.until(), LabyrinthNews::LetGo);
  table.device->press(4 | 1);
  EXPECT_EQ(table.until(0.9 * LabyrinthMenu::giveUp_s), LabyrinthNews::None);
  EXPECT_EQ(table.until(0.2 * LabyrinthMenu::giveUp_s), LabyrinthNews::GaveUp);
  EXPECT_EQ(table.host.chosen()->name, "long");
}

TEST(LabyrinthHost, TheButtonBehindTheLastLabyrinthEnds)
{
  Table table;
  table.press(4);
  EXPECT_EQ(table.until(), LabyrinthNews::End);
}

TEST(LabyrinthPlayer, PlaysEachOfThemToItsExitAndEndsOnEveryDeadMan)
{
  for (const DeadMan& deadMan : { DeadMan{}, DeadMan{ 8, false }, DeadMan{ 0, true } })
  {
    Table table(deadMan);
    const LabyrinthRun run;
    LabyrinthPlayer player(*table.device, run, table.mazes, deadMan);
    std::vector<std::string> arrived;
    LabyrinthNews news = LabyrinthNews::None;
    for (int tick = 0; tick < 600000 && news != LabyrinthNews::End; ++tick)
    {
      table.session.step(1);
      player.look(table.session.state(), table.session.parameters().map);
      news = table.host.look();
      if (news == LabyrinthNews::Arrived)
      {
        arrived.push_back(table.host.chosen()->name);
      }
    }
    EXPECT_EQ(news, LabyrinthNews::End);
    EXPECT_THAT(arrived, ElementsAre("short", "long"));
  }
}

} // namespace
} // namespace palpate
