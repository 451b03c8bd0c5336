// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "haptics/geometry/CurveChains.h"
#include "haptics/geometry/InkLines.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

Bitmap draw(std::uint32_t size, const std::function<bool(double, double)>& ink)
{
  Bitmap drawing{ size, size, {} };
  for (std::uint32_t y = 0; y < size; ++y)
  {
    for (std::uint32_t x = 0; x < size; ++x)
    {
      drawing.ink.push_back(ink(x, y) ? 1 : 0);
    }
  }
  return drawing;
}

std::vector<CurveChain> chainsOf(const LooseLines& lines)
{
  return joinSegments(lines.segments, lines.points_W.size());
}

/// Pieces of ink that hang together over corners, or of paper that do over sides: flood filling.
int pieces(const Bitmap& drawing, bool ofInk)
{
  const int size = static_cast<int>(drawing.width) + 2; // a margin of paper
  std::vector<int> seen(static_cast<std::size_t>(size * size), 0), open;
  const auto is = [&](int x, int y) { return drawing.at(x - 1, y - 1) == ofInk; };
  int count = 0;
  for (int start = 0; start < size * size; ++start)
  {
    if (seen[static_cast<std::size_t>(start)] || !is(start % size, start / size))
    {
      continue;
    }
    ++count;
    open.assign(1, start);
    seen[static_cast<std::size_t>(start)] = 1;
    while (!open.empty())
    {
      const int x = open.back() % size, y = open.back() / size;
      open.pop_back();
      for (int k = 0; k < 9; ++k)
      {
        const int nx = x + k % 3 - 1, ny = y + k / 3 - 1;
        const bool reached = ofInk || nx == x || ny == y;
        if (reached && nx >= 0 && ny >= 0 && nx < size && ny < size && is(nx, ny) &&
            !seen[static_cast<std::size_t>(ny * size + nx)])
        {
          seen[static_cast<std::size_t>(ny * size + nx)] = 1;
          open.push_back(ny * size + nx);
        }
      }
    }
  }
  return count;
}

TEST(InkLines, ThinningKeepsTheNumberOfPiecesAndOfHoles)
{
  test::Random random(test::testSeed(671));
  for (std::size_t i = 0; i < test::testCount(60); ++i)
  {
    // Blots: discs at random, so that there are pieces with and without holes.
    std::vector<Vec3> discs;
    for (int k = 0; k < 30; ++k)
    {
      discs.emplace_back(random.uniform(0, 60), random.uniform(0, 60), random.uniform(1, 8));
    }
    Bitmap drawing = draw(60,
      [&](double x, double y)
      {
        return std::any_of(discs.begin(), discs.end(),
          [&](const Vec3& d) { return std::abs(std::hypot(x - d.x(), y - d.y()) - d.z()) < 1.2; });
      });
    const int ink = pieces(drawing, true), paper = pieces(drawing, false);
    thin(drawing);
    ASSERT_EQ(pieces(drawing, true), ink) << "case " << i;
    ASSERT_EQ(pieces(drawing, false), paper) << "case " << i;
    const Bitmap once = drawing;
    thin(drawing); // which begins by asking all of them
    ASSERT_EQ(drawing.ink, once.ink) << "case " << i << ": a pixel that may go was not asked";
  }
}

// Ink goes from both sides in turn, one pixel at a time: what is left is within a pixel of the middle.
TEST(InkLines, AThickRingBecomesOneClosedCurveAlongItsMiddle)
{
  for (const double width : { 2.0, 5.0, 12.0 })
  {
    const double radius = 40.0, middle = 60.3;
    Bitmap ring =
      draw(121, [&](double x, double y) { return std::abs(std::hypot(x - middle, y - middle) - radius) <= width / 2; });
    thin(ring);
    const LooseLines lines = linesOf(ring);
    const std::vector<CurveChain> chains = chainsOf(lines);
    ASSERT_EQ(chains.size(), 1u) << width;
    EXPECT_TRUE(chains[0].closed());
    for (const Vec3& p_W : lines.points_W)
    {
      EXPECT_NEAR((p_W - Vec3(middle, middle, 0)).norm(), radius, 1.5) << width;
    }
  }
}

TEST(InkLines, ABendAndACrossHaveNoLittleTriangles)
{
  const Bitmap bend = draw(9, [](double x, double y) { return (y == 4 && x <= 4) || (x == 4 && y >= 4); });
  EXPECT_EQ(chainsOf(linesOf(bend)).size(), 1u);
  const Bitmap cross = draw(9, [](double x, double y) { return y == 4 || x == 4; });
  EXPECT_EQ(chainsOf(linesOf(cross)).size(), 4u);
}

/// A circle drawn with a gap of so many pixels between its ends.
LooseLines brokenRing(double gap)
{
  const double radius = 40.0, half = gap / 2 / radius;
  Bitmap ring = draw(121, [&](double x, double y)
    { return std::abs(std::hypot(x - 60, y - 60) - radius) <= 2 && std::abs(std::atan2(y - 60, x - 60)) >= half; });
  thin(ring);
  return linesOf(ring);
}

TEST(InkLines, AGapIsClosedWhereItIsNoLongerThanAskedAndLeftWhereItIs)
{
  for (const auto& [size, closed] : { std::pair(16.0, true), std::pair(7.0, false) })
  {
    LooseLines lines = brokenRing(10.0); // up to 2 pixels of each end go as the stroke is thinned
    mendGaps(lines, size);
    const std::vector<CurveChain> chains = chainsOf(lines);
    ASSERT_EQ(chains.size(), 1u);
    EXPECT_EQ(chains[0].closed(), closed) << size;
  }
}

TEST(InkLines, AnEndIsJoinedToTheSideOfAnotherLineAndAHookIsLeftOut)
{
  // A wall of points along x with a hook of length 2, and a line that ends 3 above the wall.
  LooseLines lines;
  for (std::uint32_t i = 0; i <= 20; ++i)
  {
    lines.points_W.emplace_back(i, 0.0, 0.0);
    if (i > 0)
    {
      lines.segments.push_back({ i - 1, i });
    }
  }
  lines.points_W.insert(lines.points_W.end(), { { 5, -2, 0 }, { 12, 3, 0 }, { 12, 30, 0 } });
  lines.segments.push_back({ 5, 21 });
  lines.segments.push_back({ 22, 23 });
  mendGaps(lines, 4.0);
  const auto has = [&](std::uint32_t a, std::uint32_t b) {
    return std::find(lines.segments.begin(), lines.segments.end(), std::array{ a, b }) != lines.segments.end();
  };
  EXPECT_TRUE(has(22, 12));
  EXPECT_FALSE(has(5, 21));
  EXPECT_EQ(chainsOf(lines).size(), 3u); // both halves of the wall and the line between them
}

} // namespace
} // namespace palpate
