// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>

#include <gtest/gtest.h>

#include "devices/simulated/labyrinth/LabyrinthRun.h"
#include "devices/simulated/labyrinth/PlaceMemory.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

using Place = PlaceMemory::Place;

/// A board of rooms, doors open or not by chance.
class Rooms
{
public:
  static constexpr int side = 6;

  explicit Rooms(test::Random& random)
  {
    for (int x = 0; x < side; ++x)
    {
      for (int y = 0; y < side; ++y)
      {
        for (const int way : { 0, 1 })
        {
          if (random.uniform(0, 1) < 0.5)
          {
            this->doors_.insert({ { x, y }, PlaceMemory::beside({ x, y }, way) });
          }
        }
      }
    }
  }

  [[nodiscard]] bool open(const Place& a, const Place& b) const
  {
    return inside(a) && inside(b) && (this->doors_.contains({ a, b }) || this->doors_.contains({ b, a }));
  }

  /// All that can be reached, by a search that sees the doors.
  [[nodiscard]] std::set<Place> reachable(const Place& from) const
  {
    std::set<Place> seen{ from };
    std::vector<Place> queue{ from };
    for (std::size_t i = 0; i < queue.size(); ++i)
    {
      for (int way = 0; way < PlaceMemory::ways; ++way)
      {
        const Place next = PlaceMemory::beside(queue[i], way);
        if (this->open(queue[i], next) && seen.insert(next).second)
        {
          queue.push_back(next);
        }
      }
    }
    return seen;
  }

private:
  [[nodiscard]] static bool inside(const Place& p)
  {
    return p.first >= 0 && p.second >= 0 && p.first < side && p.second < side;
  }

  std::set<std::pair<Place, Place>> doors_;
};

TEST(PlaceMemory, EveryPlaceThatCanBeReachedIsSeenNoDoorIsWalkedMoreThanTwiceAndTheWalkEndsWhereItBegan)
{
  test::Random random(test::testSeed(1));
  for (int board = 0; board < static_cast<int>(test::testCount(200)); ++board)
  {
    const Rooms rooms(random);
    PlaceMemory memory({ 0, 0 });
    std::set<Place> seen{ { 0, 0 } };
    std::map<std::pair<Place, Place>, int> walks;
    while (const std::optional<int> way = memory.next())
    {
      const Place from = memory.here(), to = PlaceMemory::beside(from, *way);
      if (!rooms.open(from, to))
      {
        memory.closed(*way);
        continue;
      }
      memory.walked(*way);
      seen.insert(to);
      const std::pair<Place, Place> door(std::min(from, to), std::max(from, to));
      ASSERT_LE(++walks[door], 2);
    }
    EXPECT_EQ(seen, rooms.reachable({ 0, 0 }));
    EXPECT_EQ(memory.here(), (Place{ 0, 0 }));
  }
}

/// Two corridors of width 1, joined at their right ends: from the start at the lower left to the exit above it.
Labyrinth hairpin()
{
  Labyrinth labyrinth;
  labyrinth.name = "hairpin";
  labyrinth.curves = { { { 0, 0 }, { 4, 0 }, { 4, 2 }, { 0, 2 }, { 0, 1 }, { 3, 1 } },
    { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 4, 5 } } };
  labyrinth.start_W = Eigen::Vector2d(0.5, 0.5);
  labyrinth.exit_W = Eigen::Vector2d(0.5, 1.5);
  return labyrinth;
}

// The shortest path of the disc is along the wall between the corridors and round its end: two straights of 2.5, less
// the reach of the exit, and half a circle of at least the disc's radius.
TEST(BlindHand, GoesThroughAHairpinRoundTheEndOfItsWallAndNotThroughIt)
{
  const LabyrinthOutcome outcome = runBlind(hairpin(), {});
  EXPECT_EQ(outcome.problem, "");
  EXPECT_GE(outcome.way_u, 2 * 2.5 - hairpin().exitReach_u());
}

TEST(BlindHand, IsTheSameInEveryRun)
{
  const LabyrinthOutcome a = runBlind(hairpin(), {}), b = runBlind(hairpin(), {});
  EXPECT_EQ(a.problem, "");
  EXPECT_EQ(a.time_s, b.time_s);
  EXPECT_EQ(a.way_u, b.way_u);
}

TEST(BlindHand, SaysThatAWorldWithoutAWayHasNone)
{
  Labyrinth closed = hairpin();
  closed.curves.points_W[5] = { 4, 1 };
  const LabyrinthOutcome outcome = runBlind(closed, {});
  EXPECT_NE(outcome.problem.find("all reachable"), std::string::npos) << outcome.problem;
}

/// Rooms of one corridor each with one path between any two of them, so that many walls end where a hand looks for a
/// place. A line so far away makes them a tenth of a workspace: 1.4 mm on a joystick, where a wall gives 0.3 N.
class Board
{
public:
  static constexpr int side = 5;
  static constexpr double far_u = 50.0;

  explicit Board(test::Random& random)
  {
    std::iota(this->area_.begin(), this->area_.end(), 0);
    std::vector<std::array<int, 2>> walls; // between room a and room b
    for (int room = 0; room < side * side; ++room)
    {
      if (room % side + 1 < side)
      {
        walls.push_back({ room, room + 1 });
      }
      if (room + side < side * side)
      {
        walls.push_back({ room, room + side });
      }
    }
    random.shuffle(walls);
    for (const auto& [a, b] : walls)
    {
      this->open(a, b) ? static_cast<void>(0) : this->wall(a, b);
    }
    this->line({ far_u, far_u }, { far_u, far_u - 1 });
    this->line({ 0, 0 }, { side, 0 });
    this->line({ side, 0 }, { side, side });
    this->line({ side, side }, { 0, side });
    this->line({ 0, side }, { 0, 0 });
    this->labyrinth_.name = "board";
    this->labyrinth_.start_W = Eigen::Vector2d(0.5, 0.5);
    this->labyrinth_.exit_W = Eigen::Vector2d(side - 0.5, side - 0.5);
  }

  [[nodiscard]] const Labyrinth& labyrinth() const { return this->labyrinth_; }

private:
  /// A door between two rooms that are not joined yet joins all that each is joined with.
  bool open(int a, int b)
  {
    const int from = this->area_[static_cast<std::size_t>(a)], to = this->area_[static_cast<std::size_t>(b)];
    std::replace(this->area_.begin(), this->area_.end(), from, to);
    return from != to;
  }

  void wall(int a, int b)
  {
    const double x = b % side, y = static_cast<double>(b / side);
    b == a + 1 ? this->line({ x, y }, { x, y + 1 }) : this->line({ x, y }, { x + 1, y });
  }

  void line(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
  {
    const auto first = static_cast<std::uint32_t>(this->labyrinth_.curves.points_W.size());
    this->labyrinth_.curves.points_W.insert(this->labyrinth_.curves.points_W.end(), { a, b });
    this->labyrinth_.curves.segments.push_back({ first, first + 1 });
  }

  std::array<int, static_cast<std::size_t>(side* side)> area_{};
  Labyrinth labyrinth_;
};

/// Every device in every hand that holds it, by the host's force and, where it can, by walls it holds itself.
std::vector<LabyrinthRun> everyRun()
{
  std::vector<LabyrinthRun> runs;
  for (const DeviceModel& device : deviceModels())
  {
    for (const HandModel& hand : handModels())
    {
      if (hand.stiffness_N_per_m > 0.0 && !device.turns()) // in a maze a handle that turns goes as one that does not
      {
        runs.push_back({ .device = device, .hand = hand });
        if (device.loop_s > 0.0)
        {
          runs.push_back({ .device = device, .hand = hand, .host_Hz = 20.0, .deviceHoldsWalls = true });
        }
      }
    }
  }
  return runs;
}

// A path has been left open between any two rooms, so a hand that tells walls from places arrives.
TEST(BlindHand, FindsItsWayWithEveryDeviceInEveryHandAmongEndsOfWallsThatPushNoHarderThanFriction)
{
  test::Random random(test::testSeed(2));
  for (std::size_t i = 0; i < test::testCount(1); ++i)
  {
    const Board board(random);
    for (const LabyrinthRun& run : everyRun())
    {
      EXPECT_EQ(runBlind(board.labyrinth(), run).problem, "")
        << "board " << i << ", " << run.device.name << " in a hand that is " << run.hand.name
        << (run.deviceHoldsWalls ? ", with walls it holds" : "");
    }
  }
}

TEST(BlindHand, IsNotSentWithAHandThatHoldsNothing)
{
  LabyrinthRun run;
  run.hand = *handModel("none");
  EXPECT_NE(runBlind(hairpin(), run).problem.find("no stiffness"), std::string::npos);
}

// A place is reached within 0.15 of a corridor; an encoder leaves the handle open by its step along both axes.
TEST(BlindHand, IsSentWithEncoderStepsUpToTheCoarsestThatTellAPlaceAndRefusedBeyond)
{
  const Labyrinth maze = hairpin();
  LabyrinthRun run;
  const double corridor_m = maze.corridor_u / fitted(maze, run.device.workspaceRadius_m).scale_u_per_m;
  const double coarsest_m = 0.15 * corridor_m / std::sqrt(2.0);
  for (const HandModel& hand : handModels())
  {
    run.hand = hand;
    run.device.encoderStep_m = 0.999 * coarsest_m;
    EXPECT_EQ(runBlind(maze, run).problem.empty(), hand.stiffness_N_per_m > 0.0) << hand.name;
  }
  run.device.encoderStep_m = 1.001 * coarsest_m;
  EXPECT_NE(runBlind(maze, run).problem.find("resolution of"), std::string::npos);
}

TEST(BlindHand, IsNotSentIntoAStructureWithoutAnExit)
{
  Labyrinth structure = hairpin();
  structure.exit_W.reset();
  const LabyrinthOutcome outcome = runBlind(structure, {});
  EXPECT_EQ(outcome.problem, refuse(structure));
  EXPECT_EQ(outcome.time_s, 0.0);
}

} // namespace
} // namespace palpate
