// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/geometry/mesh/PolygonCut.h"
#include "testing/support/Meshes.h"
#include "testing/support/Probe.h"
#include "testing/support/Random.h"

using namespace palpate;
using namespace palpate::test;

namespace
{

using Triangles = std::vector<std::array<std::uint32_t, 3>>;
using Loop = std::vector<Vec3>;

std::vector<std::uint32_t> numbersOf(const Loop& loop)
{
  std::vector<std::uint32_t> corners(loop.size());
  std::iota(corners.begin(), corners.end(), 0u);
  return corners;
}

struct Cut
{
  PolygonCut what;
  TriangleMesh mesh;
};

Cut cut(const Loop& loop)
{
  Cut made;
  made.mesh.vertices_W = loop;
  made.what = cutPolygon(loop, numbersOf(loop), made.mesh.triangles);
  return made;
}

/// Edges by their places that occur an odd number of times: the border of the polygon, whatever it looks like.
class Border
{
public:
  void add(const Vec3& a, const Vec3& b)
  {
    const Key from{ a.x(), a.y(), a.z() }, to{ b.x(), b.y(), b.z() };
    if (from != to)
    {
      this->odd_[std::minmax(from, to)] ^= true;
    }
  }
  [[nodiscard]] std::size_t size() const
  {
    return static_cast<std::size_t>(
      std::count_if(this->odd_.begin(), this->odd_.end(), [](const auto& edge) { return edge.second; }));
  }

private:
  using Key = std::tuple<double, double, double>;
  std::map<std::pair<Key, Key>, bool> odd_;
};

void addEdges(const TriangleMesh& mesh, Border& border)
{
  for (const auto& t : mesh.triangles)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      border.add(mesh.vertices_W[t[i]], mesh.vertices_W[t[(i + 1) % 3]]);
    }
  }
}

/// Edges in which the border of the triangles and the polygon differ: a surface that was closed is open there.
std::size_t openEdges(const Loop& loop, const TriangleMesh& mesh)
{
  Border border;
  addEdges(mesh, border);
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    border.add(loop[i], loop[(i + 1) % loop.size()]);
  }
  return border.size();
}

/// Twice the area vector (shoelace); of loops of whole numbers below 2^20 exact.
Vec3 areaOf(const Loop& loop)
{
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    sum += loop[i].cross(loop[(i + 1) % loop.size()]);
  }
  return sum;
}

Vec3 areaOf(const TriangleMesh& mesh)
{
  Vec3 sum = Vec3::Zero();
  for (const auto& [a, b, c] : mesh.triangles)
  {
    sum += (mesh.vertices_W[b] - mesh.vertices_W[a]).cross(mesh.vertices_W[c] - mesh.vertices_W[a]);
  }
  return sum;
}

/// Twice the area of all triangles, which is more than that of the polygon where they cover each other.
double coverOf(const TriangleMesh& mesh)
{
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles)
  {
    sum += (mesh.vertices_W[b] - mesh.vertices_W[a]).cross(mesh.vertices_W[c] - mesh.vertices_W[a]).norm();
  }
  return sum;
}

bool cross(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
  const auto side = [](const Vec3& p, const Vec3& q, const Vec3& r) { return (q - p).cross(r - p).z(); };
  return side(a, b, c) * side(a, b, d) <= 0.0 && side(c, d, a) * side(c, d, b) <= 0.0;
}

/// Corners at whole numbers in random order, uncrossed pair by pair (each turn shortens it, so it ends): simple, and
/// as concave as chance has it. Lies in z = 0.
Loop makeSimple(std::size_t corners, Random& random)
{
  Loop loop;
  while (loop.size() < corners)
  {
    loop.emplace_back(random.below(1000), random.below(1000), 0.0);
  }
  const auto at = [&](std::size_t i) -> const Vec3& { return loop[i % loop.size()]; };
  for (bool turned = true; turned;)
  {
    turned = false;
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      for (std::size_t j = i + 2; j < loop.size(); ++j)
      {
        const double now = (at(i) - at(i + 1)).norm() + (at(j) - at(j + 1)).norm();
        const double then = (at(i) - at(j)).norm() + (at(i + 1) - at(j + 1)).norm();
        if (j + 1 - i < loop.size() && cross(at(i), at(i + 1), at(j), at(j + 1)) && then < now)
        {
          std::reverse(
            loop.begin() + static_cast<std::ptrdiff_t>(i) + 1, loop.begin() + static_cast<std::ptrdiff_t>(j) + 1);
          turned = true;
        }
      }
    }
  }
  return loop;
}

/// A rectangle with star-shaped holes, each reached from the lower side by a cut that is gone there and back.
Loop makeKeyholes(std::size_t holes, Random& random)
{
  constexpr double cell = 1000.0;
  Loop loop = { { 0, 0, 0 } };
  for (std::size_t h = 0; h < holes; ++h)
  {
    const Vec3 centre(cell * (static_cast<double>(h) + 0.5), cell, 0.0);
    const std::size_t corners = 3 + random.below(12);
    Loop hole;
    for (std::size_t i = 0; i < corners; ++i) // clockwise, beginning below the centre
    {
      const double angle = -std::numbers::pi * (0.5 + 2.0 * static_cast<double>(i) / static_cast<double>(corners));
      const double radius = random.uniform(100.0, 450.0);
      hole.emplace_back(
        std::round(centre.x() + radius * std::cos(angle)), std::round(centre.y() + radius * std::sin(angle)), 0);
    }
    const Vec3 foot(hole[0].x(), 0.0, 0.0);
    loop.push_back(foot);
    loop.insert(loop.end(), hole.begin(), hole.end());
    loop.insert(loop.end(), { hole[0], foot });
  }
  const double width = cell * static_cast<double>(holes);
  loop.insert(loop.end(), { { width, 0, 0 }, { width, 2 * cell, 0 }, { 0, 2 * cell, 0 } });
  return loop;
}

/// The same in a slanted plane of whole numbers, exactly.
Loop slanted(const Loop& loop)
{
  Loop moved;
  for (const Vec3& p : loop)
  {
    moved.emplace_back(p.x() + 2 * p.y(), 3 * p.y() - p.x(), 2 * p.x() + p.y());
  }
  return moved;
}

/// For a loop of whole numbers that is flat and does not cross itself.
void expectFilledOnce(const Loop& loop)
{
  const Cut made = cut(loop);
  EXPECT_EQ(made.what.holeEdges, 0u);
  EXPECT_EQ(openEdges(loop, made.mesh), 0u);
  EXPECT_EQ(areaOf(made.mesh), areaOf(loop)) << "exact: whole numbers";
  const double area = areaOf(loop).norm();
  EXPECT_NEAR(coverOf(made.mesh), area, 1e-12 * area) << "nothing twice and nothing outside";
}

/// Whether p is inside an odd number of times, seen along z. p lies on no edge.
bool isInside(const Loop& loop, double x, double y)
{
  bool inside = false;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const Vec3 &a = loop[i], &b = loop[(i + 1) % loop.size()];
    if ((a.y() > y) != (b.y() > y) && x < a.x() + (y - a.y()) * (b.x() - a.x()) / (b.y() - a.y()))
    {
      inside = !inside;
    }
  }
  return inside;
}

/// Straight pushes through the inside of a polygon in z = 0 that nothing holds, of `pushes`.
int fallsThrough(const Loop& loop, const TriangleMesh& mesh, int pushes, Random& random)
{
  const auto scene = sceneOf(mesh);
  Vec3 low = loop[0], high = loop[0];
  for (const Vec3& p : loop)
  {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  int through = 0;
  while (pushes > 0)
  {
    const double x = random.uniform(low.x(), high.x()), y = random.uniform(low.y(), high.y());
    if (isInside(loop, x, y))
    {
      Probe probe(scene, 0.0, { x, y, 20.0 });
      probe.along({ x, y, -20.0 }, 8);
      through += probe.x_W().z() < -1.0;
      --pushes;
    }
  }
  return through;
}

Loop starOf(std::size_t points, std::size_t step)
{
  Loop star;
  for (std::size_t i = 0; i < points; ++i)
  {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i * step % points) / static_cast<double>(points);
    star.emplace_back(100.0 * std::cos(angle), 100.0 * std::sin(angle), 0.0);
  }
  return star;
}

} // namespace

TEST(PolygonCut, AnySimplePolygonIsCoveredOnce)
{
  Random random(testSeed(71));
  for (std::size_t i = 0; i < testCount(300); ++i)
  {
    const Loop loop = makeSimple(4 + random.below(40), random);
    expectFilledOnce(loop);
    expectFilledOnce(slanted(loop));
    expectFilledOnce({ loop.rbegin(), loop.rend() });
  }
}

TEST(PolygonCut, HolesByKeyholesStayHolesAndTheRestIsFilled)
{
  Random random(testSeed(72));
  for (std::size_t i = 0; i < testCount(100); ++i)
  {
    const Loop loop = makeKeyholes(1 + random.below(6), random);
    expectFilledOnce(loop);
    expectFilledOnce(slanted(loop));
    EXPECT_FALSE(cut(loop).what.lasts) << "a keyhole's two sides have numbers of their own here";
  }
}

TEST(PolygonCut, APointPushedOnAKeyholePolygonNeverFallsThrough)
{
  Random random(testSeed(73));
  const Loop loop = makeKeyholes(3, random);
  EXPECT_EQ(fallsThrough(loop, cut(loop).mesh, 400, random), 0);
}

TEST(PolygonCut, CornersOnALineAreUsed)
{
  // a square of side 4 with a corner at every whole number of its border
  Loop loop;
  for (int side = 0; side < 4; ++side)
  {
    for (int i = 0; i < 4; ++i)
    {
      const double a = i, b = 4 - i;
      loop.push_back(side == 0 ? Vec3(a, 0, 0) : side == 1 ? Vec3(4, a, 0) : side == 2 ? Vec3(b, 4, 0) : Vec3(0, b, 0));
    }
  }
  expectFilledOnce(loop);
  EXPECT_EQ(cut(loop).mesh.triangles.size(), loop.size() - 2);
}

TEST(PolygonCut, ACornerInTheMiddleOfADiagonalsQuadrilateralIsUsed)
{
  expectFilledOnce({ { 0, 0, 0 }, { 2, 0, 0 }, { 4, 0, 0 }, { 0, 3, 0 } });
  expectFilledOnce({ { 0, 0, 0 }, { 4, 0, 0 }, { 1, 1, 0 }, { 0, 4, 0 } }); // concave: one diagonal is outside
}

TEST(PolygonCut, TouchingItselfAtACornerOrOnAnEdge)
{
  expectFilledOnce({ { 0, 0, 0 }, { 4, 0, 0 }, { 2, 2, 0 }, { 4, 4, 0 }, { 0, 4, 0 }, { 2, 2, 0 } }); // at a corner
  const Loop onAnEdge = { { 0, 0, 0 }, { 8, 0, 0 }, { 8, 4, 0 }, { 4, 0, 0 },
    { 0, 4, 0 } }; // (4, 0) is on the first edge
  expectFilledOnce(onAnEdge);
}

TEST(PolygonCut, RepeatedCornersSpikesAndLoopsGoneTwice)
{
  const Vec3 a(0, 0, 0), b(4, 0, 0), c(4, 3, 0), d(0, 3, 0), outside(9, 9, 0), inside(1, 1, 0);
  expectFilledOnce({ a, a, b, b, b, c, d, d });
  expectFilledOnce({ a, b, c, outside, c, d });
  expectFilledOnce({ a, inside, a, b, c, d });
  EXPECT_EQ(openEdges({ a, b, c, a, b, c }, cut({ a, b, c, a, b, c }).mesh), 0u);
  EXPECT_TRUE(cut({ a, b, a, b }).mesh.triangles.empty() || coverOf(cut({ a, b, a, b }).mesh) == 0.0);
}

TEST(PolygonCut, WhatCrossesItselfIsClosedWhereItIsInsideAnOddNumberOfTimes)
{
  Random random(testSeed(74));
  for (const Loop& loop :
    { starOf(5, 2), starOf(9, 4), Loop{ { 0, 0, 0 }, { 90, 90, 0 }, { 90, 0, 0 }, { 0, 90, 0 } } })
  {
    const Cut made = cut(loop);
    EXPECT_EQ(openEdges(loop, made.mesh), 0u);
    EXPECT_EQ(fallsThrough(loop, made.mesh, 200, random), 0);
  }
}

TEST(PolygonCut, AnyLoopInSpaceIsClosed)
{
  Random random(testSeed(75));
  for (std::size_t i = 0; i < testCount(2000); ++i)
  {
    Loop loop;
    const double flat = std::pow(10.0, random.uniform(-18.0, 0.0)), grid = random.below(2) == 0 ? 3.0 : 1e6;
    for (std::size_t n = 4 + random.below(12); n > 0;
         --n) // on a coarse grid many corners are in one place or on a line
    {
      const Vec3 p = (random.inCube(1.0) * grid).array().round().matrix();
      loop.emplace_back(p.x(), p.y(), flat * p.z());
    }
    const Cut made = cut(loop);
    EXPECT_EQ(openEdges(loop, made.mesh), 0u) << "case " << i;
    EXPECT_LE(made.mesh.triangles.size(), 3 * loop.size());
  }
}

TEST(PolygonCut, SizesNearTheLimitsOfDoublesAreCutAsAnyOther)
{
  const Loop arrow = { { 0, 0, 0 }, { 4, 4, 8 }, { 0, 1, 1 }, { -4, 4, 0 }, { -1, 1, 0 } }; // 2 z = x + y
  for (const double scale : { 0x1p-1000, 0x1p-500, 1.0, 0x1p500, 0x1p1000 })
  {
    Loop loop = arrow;
    for (Vec3& p : loop)
    {
      p = scale * Vec3(p.x(), p.y(), (p.x() + p.y()) / 2);
    }
    const Cut made = cut(loop);
    EXPECT_EQ(openEdges(loop, made.mesh), 0u) << scale;
    EXPECT_EQ(made.mesh.triangles.size(), 3u) << scale;
  }
}

TEST(PolygonCut, APolygonOfSubnormalCornersIsCutAsTheSameInWholeNumbers)
{
  Random random(testSeed(76));
  for (std::size_t i = 0; i < testCount(100); ++i)
  {
    const Loop loop = makeSimple(5 + random.below(20), random);
    Loop tiny = loop;
    for (Vec3& p : tiny)
    {
      p *= std::numeric_limits<double>::denorm_min();
    }
    EXPECT_EQ(cut(tiny).mesh.triangles, cut(loop).mesh.triangles) << "case " << i;
  }
}

TEST(PolygonCut, CornersOfAllSizesAtOnceAreClosed)
{
  Random random(testSeed(77));
  for (std::size_t i = 0; i < testCount(500); ++i)
  {
    Loop loop;
    for (std::size_t n = 4 + random.below(8); n > 0; --n)
    {
      const Vec3 p = random.inCube(1.0);
      const auto sized = [&](double x) { return std::scalbn(x, static_cast<int>(random.below(2000)) - 1073); };
      loop.emplace_back(sized(p.x()), sized(p.y()), sized(p.z()));
    }
    EXPECT_EQ(openEdges(loop, cut(loop).mesh), 0u) << "case " << i;
  }
}

TEST(PolygonCut, TheShorterDiagonalOfAConvexQuadrilateral)
{
  const Triangles across = { { 0, 1, 2 }, { 0, 2, 3 } }, along = { { 1, 2, 3 }, { 1, 3, 0 } };
  EXPECT_EQ(cut({ { 0, 0, 0 }, { 4, 0, 0 }, { 5, 1, 0 }, { 1, 1, 0 } }).mesh.triangles, along);
  EXPECT_EQ(cut({ { 1, 0, 0 }, { 5, 0, 0 }, { 4, 1, 0 }, { 0, 1, 0 } }).mesh.triangles, across);
}

TEST(PolygonCut, ACutLastsWhereNoOtherCouldBeNeeded)
{
  const Loop square = { { 0, 0, 0 }, { 4, 0, 0 }, { 4, 4, 0 }, { 0, 4, 0 } };
  EXPECT_TRUE(cut(square).what.lasts);
  EXPECT_FALSE(cut({ square[0], square[2], square[1], square[3] }).what.lasts) << "it crosses itself";
  const Loop keyhole = { square[0], { 1, 1, 0 }, { 2, 1, 0 }, { 1, 2, 0 }, { 1, 1, 0 }, square[0], square[3], square[2],
    square[1] };
  EXPECT_FALSE(cut(keyhole).what.lasts) << "the sides of the way to the hole may part";
  Triangles triangles;
  EXPECT_TRUE(cutPolygon(keyhole, std::vector<std::uint32_t>{ 0, 1, 2, 3, 1, 0, 6, 7, 8 }, triangles).lasts)
    << "they are one edge";
}

TEST(PolygonCut, ACornerThatIsNotFiniteLeavesAHoleOfAllEdges)
{
  Loop loop = starOf(7, 1);
  loop[3].y() = std::numeric_limits<double>::quiet_NaN();
  const Cut made = cut(loop);
  EXPECT_EQ(made.what.holeEdges, 7u);
  EXPECT_TRUE(made.mesh.triangles.empty());
}

TEST(PolygonCut, FewerThanFourCornersAreWhatTheyAre)
{
  EXPECT_EQ(cut({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }).mesh.triangles, (Triangles{ { 0, 1, 2 } }));
  EXPECT_TRUE(cut({ { 0, 0, 0 }, { 1, 0, 0 } }).mesh.triangles.empty());
  EXPECT_TRUE(cut({}).mesh.triangles.empty());
}

namespace
{

/// A corner of a rectangle around (x, 0), counterclockwise from the lower left one.
Vec3 cornerOf(double x, double halfWidth, double halfHeight, int i, double z)
{
  return { x + (i % 4 == 0 || i % 4 == 3 ? -halfWidth : halfWidth), i % 4 < 2 ? -halfHeight : halfHeight, z };
}

constexpr double plateWidth = 10.0, plateHeight = 6.0, thickness = 4.0, window = 2.0, windowAt = 5.0; // half sizes

Vec3 plateCorner(int i, double z)
{
  return cornerOf(0.0, plateWidth, plateHeight, i, z);
}

/// One side of a plate with two windows as one polygon: round the plate, and from a corner to each window and back.
Loop rimOf(double z, bool withMiddles)
{
  Loop rim;
  for (int i = 0; i < 4; ++i)
  {
    rim.push_back(plateCorner(i, z));
    for (int k = 0; i < 2 && k <= 4; ++k)
    {
      rim.push_back(cornerOf(i == 0 ? -windowAt : windowAt, window, window, i + 4 - k, z));
    }
    if (i < 2)
    {
      rim.push_back(plateCorner(i, z));
    }
    if (withMiddles)
    {
      rim.push_back((plateCorner(i, z) + plateCorner(i + 1, z)) / 2);
    }
  }
  return rim;
}

/// A double torus of planar polygons: that plate. Its outer walls are pentagons with three corners on a line.
std::vector<Loop> makeDoubleTorus()
{
  const Loop under = rimOf(0.0, false);
  std::vector<Loop> faces = { Loop(under.rbegin(), under.rend()), rimOf(thickness, true) };
  for (int i = 0; i < 4; ++i)
  {
    const Vec3 a = plateCorner(i, thickness), b = plateCorner(i + 1, thickness);
    faces.push_back({ plateCorner(i, 0), plateCorner(i + 1, 0), b, (a + b) / 2, a });
    for (const double x : { -windowAt, windowAt })
    {
      const auto at = [x](int k, double z) { return cornerOf(x, window, window, k, z); };
      faces.push_back({ at(i + 1, 0), at(i, 0), at(i, thickness), at(i + 1, thickness) });
    }
  }
  return faces;
}

} // namespace

TEST(PolygonCut, ADoubleTorusOfPlanarPolygonsStaysOne)
{
  TriangleMesh mesh;
  for (const Loop& face : makeDoubleTorus())
  {
    append(mesh, cut(face).mesh);
  }
  const CleanReport report = cleanMesh(mesh).report;
  EXPECT_EQ(report.boundaryEdges + report.nonManifoldEdges + report.collinear, 0u);
  const auto vertices = static_cast<int>(report.verticesOut), triangles = static_cast<int>(report.trianglesOut);
  EXPECT_EQ(vertices - triangles / 2, 2 - 2 * 2) << "Euler: V - E + F, where E = 3 F / 2, of two handles";
  double volume = 0.0;
  for (const auto& [a, b, c] : mesh.triangles)
  {
    volume += mesh.vertices_W[a].dot(mesh.vertices_W[b].cross(mesh.vertices_W[c])) / 6.0;
  }
  EXPECT_NEAR(volume, thickness * 4.0 * (plateWidth * plateHeight - 2.0 * window * window), 1e-9);
}

TEST(PolygonCut, HolesAreSaidWithTheirEdges)
{
  EXPECT_EQ(describeHoles({}), "");
  EXPECT_EQ(describeHoles({ 5 }).substr(0, 18), "1 hole of 5 edges:");
  EXPECT_EQ(describeHoles({ 5, 7, 4 }).substr(0, 27), "3 holes of 5, 7 and 4 edges");
  EXPECT_EQ(
    describeHoles(std::vector<std::size_t>(20, 4)).substr(0, 45), "20 holes of 4, 4, 4, 4, 4, 4, 4, 4, ... edges");
}
