// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "haptics/geometry/curves/CurveChains.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

using Segment = std::array<std::uint32_t, 2>;

TEST(CurveChains, ARingAnOpenLineAndAForkAreJoinedAtTheirEnds)
{
  // A square 0-1-2-3, a line 4-5-6, and three lines that meet in 7.
  const std::vector<Segment> segments{ { 2, 3 }, { 1, 0 }, { 3, 0 }, { 1, 2 }, { 6, 5 }, { 4, 5 }, { 7, 8 }, { 9, 7 },
    { 7, 10 } };
  const std::vector<CurveChain> chains = joinSegments(segments, 11);
  ASSERT_EQ(chains.size(), 5u);
  EXPECT_EQ(chains[0].points, (std::vector<std::uint32_t>{ 4, 5, 6 }));
  EXPECT_EQ(chains[1].points, (std::vector<std::uint32_t>{ 7, 8 }));
  EXPECT_EQ(chains[4].points, (std::vector<std::uint32_t>{ 0, 1, 2, 3, 0 }));
  EXPECT_TRUE(chains[4].closed());
  EXPECT_FALSE(chains[0].closed());
}

std::vector<Segment> randomSegments(test::Random& random, std::uint32_t points, std::size_t count)
{
  std::vector<Segment> segments;
  for (std::size_t i = 0; i < count; ++i)
  {
    segments.push_back({ random.below(points), random.below(points) });
  }
  return segments;
}

// A chain has two ends; only points of another degree than two have ends, one for each segment there.
TEST(CurveChains, HoldEverySegmentOnceAndAreAsFewAsTheEndsAllow)
{
  test::Random random(test::testSeed(641));
  for (std::size_t i = 0; i < test::testCount(300); ++i)
  {
    const std::uint32_t points = 2 + random.below(30);
    std::vector<Segment> segments = randomSegments(random, points, random.below(60));
    std::set<Segment> wanted;
    std::map<std::uint32_t, int> degree;
    for (const auto& [a, b] : segments)
    {
      if (a != b && wanted.insert({ std::min(a, b), std::max(a, b) }).second)
      {
        ++degree[a], ++degree[b];
      }
    }
    std::multiset<Segment> held;
    std::size_t rings = 0, ends = 0;
    for (const auto& [p, count] : degree)
    {
      ends += count == 2 ? 0 : static_cast<std::size_t>(count);
    }
    const std::vector<CurveChain> chains = joinSegments(segments, points);
    for (const CurveChain& chain : chains)
    {
      rings += degree[chain.points.front()] == 2 ? 1 : 0;
      for (std::size_t k = 1; k < chain.points.size(); ++k)
      {
        held.insert({ std::min(chain.points[k - 1], chain.points[k]), std::max(chain.points[k - 1], chain.points[k]) });
      }
    }
    ASSERT_TRUE(std::equal(held.begin(), held.end(), wanted.begin(), wanted.end())) << "case " << i;
    ASSERT_EQ(chains.size() - rings, ends / 2) << "case " << i;
    random.shuffle(segments);
    const std::vector<CurveChain> again = joinSegments(segments, points);
    ASSERT_TRUE(std::equal(again.begin(), again.end(), chains.begin(), chains.end(),
      [](const CurveChain& a, const CurveChain& b) { return a.points == b.points; }));
  }
}

} // namespace
} // namespace palpate
