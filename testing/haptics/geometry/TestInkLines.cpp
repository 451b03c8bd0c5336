// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "haptics/geometry/curves/CurveChains.h"
#include "haptics/geometry/ink/InkLines.h"
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

// Ink goes from both sides in turn, one pixel at a time: the rest is within a pixel of the middle.
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

/// A drawing's lines with gaps up to so many pixels closed.
LooseLines mended(const Bitmap& drawing, double gap)
{
  Bitmap thinned = drawing;
  thin(thinned);
  LooseLines lines = linesOf(thinned);
  mendGaps(lines, drawing, { 1.0, 1.0 }, gap);
  return lines;
}

// Thinning takes half its width from each end of a stroke, which is no part of the gap.
TEST(InkLines, AGapIsClosedUpToItsLengthInTheDrawingHoweverWideTheStrokes)
{
  for (const double width : { 1.0, 2.0, 3.0, 5.0, 10.0, 20.0 })
  {
    for (const double blank : { 2.0, 6.0, 13.0, 30.0 })
    {
      const Bitmap drawing = draw(160, [&](double x, double y)
        { return x >= 10 && x < 150 && y >= 60 && y < 60 + width && !(x >= 70 && x < 70 + blank); });
      EXPECT_EQ(chainsOf(mended(drawing, blank)).size(), 1u) << width << " wide, blank " << blank;
      EXPECT_EQ(chainsOf(mended(drawing, 0.99 * blank)).size(), 2u) << width << " wide, blank " << blank;
    }
  }
}

// The nearest pixels of two round ends are off from them by less than a pixel each.
TEST(InkLines, AGapBetweenRoundEndsInAnyDirectionIsClosedUpToItsLength)
{
  for (const double degrees : { 0.0, 17.0, 30.0, 45.0, 80.0 })
  {
    const double angle = degrees * std::numbers::pi / 180.0;
    for (const double width : { 3.0, 8.0, 16.0 })
    {
      for (const double blank : { 4.0, 9.0, 20.0 })
      {
        const Bitmap drawing = draw(220,
          [&](double x, double y)
          {
            const double along = std::cos(angle) * (x - 110) + std::sin(angle) * (y - 110);
            const double aside = std::cos(angle) * (y - 110) - std::sin(angle) * (x - 110);
            const double past =
              std::max({ std::abs(along) - 90, blank / 2 + width / 2 - std::abs(along), 0.0 }); // the end's middle
            return std::hypot(past, aside) <= width / 2;
          });
        EXPECT_EQ(chainsOf(mended(drawing, blank + 1.5)).size(), 1u) << degrees << " " << width << " " << blank;
        EXPECT_EQ(chainsOf(mended(drawing, blank - 1.5)).size(), 2u) << degrees << " " << width << " " << blank;
      }
    }
  }
}

TEST(InkLines, AGapIsMeasuredInSpaceWherePixelsAreOblong)
{
  // 3 blank columns of 0.7 units and 3 blank rows of 0.1: 3 * 0.1 is not 0.3 in binary
  for (const bool across : { false, true })
  {
    Bitmap drawing = draw(60, [&](double x, double y)
      { return std::abs((across ? x : y) - 30) <= 2 && !((across ? y : x) > 28 && (across ? y : x) < 32); });
    const double blank_u = across ? 0.3 : 2.1;
    for (const auto& [gap_u, chains] : { std::pair(blank_u, 1u), std::pair(0.99 * blank_u, 2u) })
    {
      Bitmap thinned = drawing;
      thin(thinned);
      LooseLines lines = linesOf(thinned);
      mendGaps(lines, drawing, { 0.7, 0.1 }, gap_u);
      EXPECT_EQ(chainsOf(lines).size(), chains) << across << " " << gap_u;
    }
  }
}

TEST(InkLines, ABrokenRingIsClosedWhereItsGapIsNoLongerThanAskedAndLeftWhereItIs)
{
  const double radius = 40.0, half = 5.0 / radius; // a blank of 10 along the middle, of 9.5 along the inner rim
  const Bitmap ring = draw(121, [&](double x, double y)
    { return std::abs(std::hypot(x - 60, y - 60) - radius) <= 2 && std::abs(std::atan2(y - 60, x - 60)) >= half; });
  for (const auto& [size, closed] : { std::pair(11.0, true), std::pair(8.0, false) })
  {
    const std::vector<CurveChain> chains = chainsOf(mended(ring, size));
    ASSERT_EQ(chains.size(), 1u);
    EXPECT_EQ(chains[0].closed(), closed) << size;
  }
}

// A wall 9 wide, and a stroke 5 wide that ends 6 above it.
TEST(InkLines, AnEndIsJoinedStraightToTheSideOfAnotherStroke)
{
  const Bitmap drawing = draw(80, [](double x, double y)
    { return (std::abs(y - 60) <= 4 && x >= 5 && x <= 75) || (std::abs(x - 40) <= 2 && y >= 5 && y < 50); });
  EXPECT_EQ(chainsOf(mended(drawing, 5.9)).size(), 2u);
  const LooseLines lines = mended(drawing, 6.0);
  EXPECT_EQ(chainsOf(lines).size(), 3u); // both halves of the wall and the stroke between them
  const auto& [end, foot] = lines.segments.back();
  EXPECT_NEAR(lines.points_W[foot].x(), 40.0, 1.0);
  EXPECT_NEAR(lines.points_W[foot].y(), 60.0, 1.0);
  EXPECT_NEAR(lines.points_W[end].x(), 40.0, 1.0);
}

// Between a wall and its branch there is a corner and no gap, however short the branch.
TEST(InkLines, ABranchIsNotJoinedToTheWallItBranchesFromAndAHookIsLeftOut)
{
  for (const double length : { 10.0, 12.0, 20.0, 30.0 })
  {
    const Bitmap drawing = draw(100,
      [&](double x, double y) {
        return (std::abs(y - 60) <= 4 && x >= 5 && x <= 95) || (std::abs(x - 50) <= 3 && y <= 60 && y >= 56 - length);
      });
    // From the wall's middle the branch is 4 longer; thinning takes half the branch's width again.
    EXPECT_EQ(chainsOf(mended(drawing, length - 2)).size(), 3u) << length;
    EXPECT_EQ(chainsOf(mended(drawing, length + 6)).size(), 1u) << length;
  }
}

} // namespace
} // namespace palpate
