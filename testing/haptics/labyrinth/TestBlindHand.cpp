// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>

#include <gtest/gtest.h>

#include "devices/simulated/LabyrinthRun.h"
#include "devices/simulated/PlaceMemory.h"
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

// The shortest way of the disc is along the wall between the corridors and round its end: two straights of 2.5, less
// what the reach of the exit spares, and half a circle of at least the disc's radius.
TEST(BlindHand, GoesThroughAHairpinRoundTheEndOfItsWallAndNotThroughIt)
{
  const LabyrinthOutcome outcome = runBlind(hairpin(), {});
  EXPECT_EQ(outcome.problem, "");
  EXPECT_GE(outcome.way_u, 2 * 2.5 - hairpin().exitReach_u());
}

TEST(BlindHand, IsTheSameInEveryRun)
{
  const LabyrinthOutcome a = runBlind(hairpin(), {}), b = runBlind(hairpin(), {});
  EXPECT_EQ(a.time_s, b.time_s);
  EXPECT_EQ(a.way_u, b.way_u);
}

TEST(BlindHand, SaysThatAWorldWithoutAWayHasNone)
{
  Labyrinth closed = hairpin();
  closed.curves.points_W[5] = { 4, 1 };
  const LabyrinthOutcome outcome = runBlind(closed, {});
  EXPECT_NE(outcome.problem.find("everywhere"), std::string::npos) << outcome.problem;
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
