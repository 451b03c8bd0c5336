// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "haptics/labyrinth/CorridorWidth.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

/// A box of 10 by 4 with two walls across it that leave a gap at one end, turned, scaled and moved.
struct Gaps
{
  double size = 1.0, turn = 0.0;
  Eigen::Vector2d at_W = Eigen::Vector2d::Zero();

  [[nodiscard]] Eigen::Vector2d put(double x, double y) const
  {
    return this->at_W + this->size * (Eigen::Rotation2Dd(this->turn) * Eigen::Vector2d(x, y));
  }

  [[nodiscard]] Labyrinth made(double first, double second) const
  {
    Labyrinth maze;
    const auto wall = [&](double ax, double ay, double bx, double by)
    {
      const auto begin = static_cast<std::uint32_t>(maze.curves.points_W.size());
      maze.curves.points_W.push_back(this->put(ax, ay));
      maze.curves.points_W.push_back(this->put(bx, by));
      maze.curves.segments.push_back({ begin, begin + 1 });
    };
    wall(0, 0, 10, 0);
    wall(10, 0, 10, 4);
    wall(10, 4, 0, 4);
    wall(0, 4, 0, 0);
    wall(3, 0, 3, 4 - first); // the path round its end is `first` wide
    wall(7, second, 7, 4);
    maze.start_W = this->put(1.5, 2);
    maze.exit_W = this->put(8.5, 2);
    return maze;
  }
};

TEST(CorridorWidth, IsTheNarrowestGapOnTheWayWhereverAndHoweverLargeTheMazeIs)
{
  test::Random random(test::testSeed(607));
  for (std::size_t i = 0; i < test::testCount(40); ++i)
  {
    const Gaps gaps{ std::exp2(random.uniform(-20, 20)), random.uniform(0.0, 6.28),
      Eigen::Vector2d(random.uniform(-5, 5), random.uniform(-5, 5)) };
    const double first = random.uniform(0.3, 2.5), second = random.uniform(0.3, 2.5);
    const Labyrinth maze = gaps.made(first, second);
    const PlaneBox box = fence(maze);
    const double step_u = (box.high_W - box.low_W).maxCoeff() / 512, narrowest_u = gaps.size * std::min(first, second);
    const std::optional<double> width_u = corridorWidth(maze);
    ASSERT_TRUE(width_u) << i;
    EXPECT_GE(*width_u, narrowest_u - 3 * step_u) << i;
    EXPECT_LE(*width_u, narrowest_u + step_u) << i;
  }
}

TEST(CorridorWidth, OfTwoWaysTheWiderCounts)
{
  Labyrinth maze = Gaps().made(0.5, 3.0);
  maze.curves.points_W[8] = Gaps().put(3, 1.0); // now there is a path below the first wall too
  const std::optional<double> width_u = corridorWidth(maze);
  ASSERT_TRUE(width_u);
  EXPECT_NEAR(*width_u, 1.0, 3 * 10.0 / 512);
}

TEST(CorridorWidth, WithoutAWayThereIsNone)
{
  EXPECT_FALSE(corridorWidth(Gaps().made(0.0, 2.0)));
  Labyrinth maze = Gaps().made(1.0, 1.0);
  maze.exit_W.reset();
  EXPECT_FALSE(corridorWidth(maze));
  EXPECT_FALSE(corridorWidth(Labyrinth()));
}

} // namespace
} // namespace palpate
