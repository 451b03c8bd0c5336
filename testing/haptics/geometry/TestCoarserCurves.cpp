// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/curves/CoarserCurves.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "haptics/geometry/mesh/ExactPredicates.h"
#include "testing/support/Polylines.h"
#include "testing/support/Random.h"

namespace palpate::test
{
namespace
{

using Segment = std::array<std::uint32_t, 2>;
constexpr double limit_u = 0.07;

struct Drawing
{
  std::vector<Vec3> points_W;
  std::vector<Segment> segments;

  void add(const std::vector<Vec3>& line_W)
  {
    for (std::size_t i = 0; i < line_W.size(); ++i)
    {
      this->points_W.push_back(line_W[i]);
      const auto last = static_cast<std::uint32_t>(this->points_W.size() - 1);
      if (i > 0)
      {
        this->segments.push_back({ last - 1, last });
      }
    }
  }

  /// Its last point is its first.
  void addRing(const std::vector<Vec3>& line_W)
  {
    const auto first = static_cast<std::uint32_t>(this->points_W.size());
    this->add(line_W);
    this->segments.push_back({ static_cast<std::uint32_t>(this->points_W.size() - 1), first });
  }
};

CoarserCurves coarsen(const Drawing& drawing)
{
  return coarsestWithin(drawing.points_W, drawing.segments, limit_u);
}

std::vector<Vec3> noisyRing(
  std::size_t points, double r, double noise_u, Random& random, const Vec3& at_W = Vec3::Zero())
{
  std::vector<Vec3> ring_W;
  for (std::size_t i = 0; i < points; ++i)
  {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(points);
    ring_W.push_back(at_W + (r + random.uniform(-noise_u, noise_u)) * Vec3(std::cos(angle), std::sin(angle), 0));
  }
  return ring_W;
}

std::vector<Vec3> noisyLine(std::size_t points, const Vec3& a_W, const Vec3& b_W, double noise_u, Random& random)
{
  const Vec3 aside = Vec3(a_W.y() - b_W.y(), b_W.x() - a_W.x(), 0).normalized();
  std::vector<Vec3> line_W;
  for (std::size_t i = 0; i < points; ++i)
  {
    const double share = static_cast<double>(i) / static_cast<double>(points - 1);
    const bool end = i == 0 || i + 1 == points;
    line_W.push_back((1 - share) * a_W + share * b_W + (end ? 0.0 : random.uniform(-noise_u, noise_u)) * aside);
  }
  return line_W;
}

Segment sorted(const Segment& s)
{
  return { std::min(s[0], s[1]), std::max(s[0], s[1]) };
}

std::set<Segment> setOf(const std::vector<Segment>& segments)
{
  std::set<Segment> all;
  std::transform(segments.begin(), segments.end(), std::inserter(all, all.end()), sorted);
  return all;
}

/// Whether two segments of the plane z = 0 have a point in common, exactly.
bool touch(const std::vector<Vec3>& p, const Segment& s, const Segment& t)
{
  const auto side = [&p](std::uint32_t a, std::uint32_t b, std::uint32_t c)
  { return orientation2(p[a].x(), p[a].y(), p[b].x(), p[b].y(), p[c].x(), p[c].y()); };
  const auto apart = [&p](const Segment& u, const Segment& v, int axis)
  { return std::max(p[u[0]][axis], p[u[1]][axis]) < std::min(p[v[0]][axis], p[v[1]][axis]); };
  if (apart(s, t, 0) || apart(t, s, 0) || apart(s, t, 1) || apart(t, s, 1))
  {
    return false;
  }
  return side(s[0], s[1], t[0]) * side(s[0], s[1], t[1]) <= 0 && side(t[0], t[1], s[0]) * side(t[0], t[1], s[1]) <= 0;
}

/// Pairs of segments that meet in a point that is no end of both.
std::set<std::array<Segment, 2>> crossingsOf(const std::vector<Vec3>& points_W, std::vector<Segment> segments)
{
  std::sort(segments.begin(), segments.end(),
    [&](const Segment& s, const Segment& t)
    { return std::min(points_W[s[0]].x(), points_W[s[1]].x()) < std::min(points_W[t[0]].x(), points_W[t[1]].x()); });
  std::set<std::array<Segment, 2>> found;
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    const Segment s = sorted(segments[i]);
    const double right = std::max(points_W[s[0]].x(), points_W[s[1]].x());
    for (std::size_t j = i + 1; j < segments.size(); ++j)
    {
      const Segment t = sorted(segments[j]);
      if (std::min(points_W[t[0]].x(), points_W[t[1]].x()) > right)
      {
        break;
      }
      const bool joined = s[0] == t[0] || s[0] == t[1] || s[1] == t[0] || s[1] == t[1];
      if (!joined && touch(points_W, s, t))
      {
        found.insert({ std::min(s, t), std::max(s, t) });
      }
    }
  }
  return found;
}

/// How many segments end at each point that has any.
std::map<std::uint32_t, int> degreesOf(const std::vector<Segment>& segments)
{
  std::map<std::uint32_t, int> degrees;
  for (const auto& [a, b] : segments)
  {
    ++degrees[a];
    ++degrees[b];
  }
  return degrees;
}

/// Of points up to `noise_u` off a circle no chord over an angle a is further than the sagitta and twice the noise; so
/// 2 pi / a chords would do, and halving takes at most twice that many.
TEST(CoarserCurves, ANoisyRingStaysARingOfFewSegmentsWithinTheBoundBothWays)
{
  Random random(testSeed(661));
  const double r = 50.0, noise_u = 0.01;
  Drawing drawing;
  drawing.addRing(noisyRing(20000, r, noise_u, random));
  const CoarserCurves coarse = coarsen(drawing);
  const double angle = 2 * std::acos(1 - (limit_u - 2 * noise_u) / r);
  EXPECT_LE(coarse.segments.size(), static_cast<std::size_t>(2 * std::ceil(2 * std::numbers::pi / angle)));
  EXPECT_LE(coarse.bound_u, limit_u);
  std::vector<Vec3> before_W = drawing.points_W, after_W;
  before_W.push_back(before_W.front());
  for (const Segment& s : coarse.segments) // in their order round the ring
  {
    EXPECT_TRUE(after_W.empty() || after_W.back() == drawing.points_W[s[0]]);
    after_W.resize(std::max<std::size_t>(1, after_W.size()), drawing.points_W[s[0]]);
    after_W.push_back(drawing.points_W[s[1]]);
  }
  EXPECT_EQ(after_W.front(), after_W.back());
  EXPECT_LE(hausdorffFromBelow(before_W, after_W, 2), coarse.bound_u);
  for (const auto& [point, degree] : degreesOf(coarse.segments))
  {
    EXPECT_EQ(degree, 2) << point;
  }
  EXPECT_TRUE(crossingsOf(drawing.points_W, coarse.segments).empty());
}

TEST(CoarserCurves, ARingSmallerThanWhatIsFeltStaysARing)
{
  Random random(testSeed(662));
  Drawing drawing;
  drawing.addRing(noisyRing(1000, 0.2 * limit_u, 0.0, random));
  const CoarserCurves coarse = coarsen(drawing);
  EXPECT_EQ(coarse.segments.size(), 4U);
  EXPECT_EQ(degreesOf(coarse.segments).size(), 4U);
  Drawing triangle;
  triangle.addRing({ { 0, 0, 0 }, { 0.01, 0, 0 }, { 0, 0.01, 0 } });
  EXPECT_EQ(setOf(coarsen(triangle).segments), setOf(triangle.segments));
}

TEST(CoarserCurves, CoarseCurvesStayAsTheyAre)
{
  Random random(testSeed(663));
  Drawing drawing;
  for (int i = 0; i < 200; ++i)
  {
    drawing.add({ random.inCube(5.0), random.inCube(5.0), random.inCube(5.0) });
  }
  const CoarserCurves coarse = coarsen(drawing);
  EXPECT_EQ(setOf(coarse.segments), setOf(drawing.segments));
  EXPECT_EQ(coarse.bound_u, 0.0);
}

// Rings one inside the other, as near as a seventh of the limit.
TEST(CoarserCurves, CurvesNearerThanTheLimitThatDidNotCrossDoNot)
{
  Random random(testSeed(664));
  for (std::size_t i = 0; i < testCount(5); ++i)
  {
    Drawing drawing;
    const double apart_u = random.uniform(0.01, 0.2);
    for (int k = 0; k < 4; ++k)
    {
      // of another number of points, so that their chords would not stand over each other
      drawing.addRing(noisyRing(2000 + random.below(2000), 10.0 + apart_u * k, 0.4 * apart_u, random));
    }
    ASSERT_TRUE(crossingsOf(drawing.points_W, drawing.segments).empty());
    const CoarserCurves coarse = coarsen(drawing);
    ASSERT_TRUE(crossingsOf(drawing.points_W, coarse.segments).empty()) << "apart " << apart_u;
    for (const auto& [point, degree] : degreesOf(coarse.segments))
    {
      ASSERT_EQ(degree, 2) << point;
    }
  }
}

/// Without those beside a junction, where chains that begin there may lose crossings between their first runs.
std::set<std::array<Segment, 2>> awayFrom(
  const std::vector<Vec3>& junctions_W, const std::vector<Vec3>& points_W, std::set<std::array<Segment, 2>> crossings)
{
  std::erase_if(crossings,
    [&](const std::array<Segment, 2>& pair)
    {
      return std::any_of(junctions_W.begin(), junctions_W.end(),
        [&](const Vec3& junction_W) { return (points_W[pair[0][0]] - junction_W).norm() < limit_u; });
    });
  return crossings;
}

// A labyrinth drawn by hand: walls that end on others, walls that share points, walls that cross. All of it afterwards
// as before, of the same segments: no gap opens and none closes.
TEST(CoarserCurves, WhatWasJoinedOrCrossedStaysSoInTheSamePoints)
{
  Random random(testSeed(665));
  for (std::size_t i = 0; i < testCount(5); ++i)
  {
    Drawing drawing;
    std::vector<Vec3> junctions_W;
    const double noise_u = random.uniform(0.0, 0.03);
    for (int row = 0; row < 4; ++row)
    {
      drawing.add(noisyLine(2001, { -10, 4.0 * row, 0 }, { 10, 4.0 * row, 0 }, noise_u, random));
      const auto lower = static_cast<std::uint32_t>(drawing.points_W.size() - 1 - random.below(1900) - 50);
      const Vec3 foot_W = drawing.points_W[lower]; // another point of the same place is not the same point
      drawing.add(noisyLine(801, foot_W, foot_W + Vec3(random.uniform(-0.5, 0.5), 3, 0), noise_u, random));
      const Vec3 from_W(random.uniform(-9, 9), 4.0 * row - 0.5, 0);
      drawing.add(noisyLine(801, from_W, from_W + Vec3(random.uniform(-0.5, 0.5), 1.5, 0), noise_u, random));
      const auto shared = static_cast<std::uint32_t>(drawing.points_W.size() - 400);
      drawing.add(noisyLine(401, drawing.points_W[shared] + Vec3(1e-3, 0, 0),
        drawing.points_W[shared] + Vec3(1.5, 0.4, 0), noise_u, random));
      junctions_W.push_back(drawing.points_W[shared]);
      drawing.segments.push_back({ shared, static_cast<std::uint32_t>(drawing.points_W.size() - 401) });
    }
    const auto crossings = [&](const std::vector<Segment>& segments)
    { return awayFrom(junctions_W, drawing.points_W, crossingsOf(drawing.points_W, segments)); };
    const auto before = crossings(drawing.segments);
    ASSERT_GE(before.size(), 8U);
    const CoarserCurves coarse = coarsen(drawing);
    ASSERT_LE(4 * coarse.segments.size(), drawing.segments.size());
    ASSERT_EQ(crossings(coarse.segments), before) << "case " << i << " noise " << noise_u;
    const auto degrees = degreesOf(drawing.segments);
    auto after = degreesOf(coarse.segments);
    for (const auto& [point, degree] : degrees)
    {
      ASSERT_TRUE(degree == 2 || after[point] == degree) << point;
    }
  }
}

/// Gauss' integral over two polygons, as the solid angles of pairs of segments (Klenin & Langowski 2000).
double linkingNumber(const std::vector<Vec3>& points_W, const std::vector<Segment>& a, const std::vector<Segment>& b)
{
  double sum = 0.0;
  for (const Segment& s : a)
  {
    for (const Segment& t : b)
    {
      const Vec3 &p1 = points_W[s[0]], &p2 = points_W[s[1]], &p3 = points_W[t[0]], &p4 = points_W[t[1]];
      const Vec3 n[4] = { (p3 - p1).cross(p4 - p1).normalized(), (p4 - p1).cross(p4 - p2).normalized(),
        (p4 - p2).cross(p3 - p2).normalized(), (p3 - p2).cross(p3 - p1).normalized() };
      double angle = 0.0;
      for (int k = 0; k < 4; ++k)
      {
        angle += std::asin(std::clamp(n[k].dot(n[(k + 1) % 4]), -1.0, 1.0));
      }
      sum += std::copysign(angle, (p4 - p3).cross(p2 - p1).dot(p3 - p1));
    }
  }
  return sum / (4 * std::numbers::pi);
}

// A strand that winds round a ring at a third of the limit: a chord of the winding would lie on the ring's other side.
TEST(CoarserCurves, StrandsInSpaceThatAreLinkedStaySo)
{
  Random random(testSeed(666));
  const int turns = 50; // more than the ring would have segments left
  Drawing drawing;
  drawing.addRing(noisyRing(600, 3.0, 0.0, random));
  const std::size_t ring = drawing.segments.size();
  std::vector<Vec3> strand_W;
  for (int i = 0; i < 4000; ++i)
  {
    const double t = 2 * std::numbers::pi * i / 4000;
    const double r = 3.0 + limit_u / 3 * std::cos(turns * t);
    strand_W.emplace_back(r * std::cos(t), r * std::sin(t), limit_u / 3 * std::sin(turns * t));
  }
  drawing.addRing(strand_W);
  const auto linked = [&](const std::vector<Segment>& segments)
  {
    std::vector<Segment> a, b;
    for (const Segment& s : segments)
    {
      (s[0] < ring ? a : b).push_back(s);
    }
    return linkingNumber(drawing.points_W, a, b);
  };
  EXPECT_NEAR(std::abs(linked(drawing.segments)), turns, 1e-6);
  const CoarserCurves coarse = coarsen(drawing);
  EXPECT_LT(coarse.segments.size(), drawing.segments.size());
  EXPECT_NEAR(linked(coarse.segments), linked(drawing.segments), 1e-6);
}

TEST(CoarserCurves, TheOrderOfSegmentsPlaysNoPartAndStoppedThereIsNothing)
{
  Random random(testSeed(667));
  Drawing drawing;
  drawing.add(noisyLine(3000, { 0, 0, 0 }, { 20, 5, 0 }, 0.02, random));
  const CoarserCurves coarse = coarsen(drawing);
  random.shuffle(drawing.segments);
  EXPECT_EQ(coarsen(drawing).segments, coarse.segments);
  std::stop_source source;
  source.request_stop();
  EXPECT_TRUE(coarsestWithin(drawing.points_W, drawing.segments, limit_u, source.get_token()).segments.empty());
}

} // namespace
} // namespace palpate::test
