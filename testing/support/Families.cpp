// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/support/Families.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "testing/support/Anywhere.h"
#include "testing/support/Meshes.h"

namespace palpate::test
{
namespace
{

constexpr double degree = std::numbers::pi / 180;

double spreadEvenly10(Random& random, double low10, double high10)
{
  return std::pow(10.0, random.uniform(low10, high10));
}

/// A grid of columns x rows squares with random diagonals; place(i, j) is where its vertices are.
template<class Place>
void addGrid(TriangleMesh& mesh, int columns, int rows, Random& random, Place place)
{
  const auto first = static_cast<std::uint32_t>(mesh.vertices_W.size());
  for (int j = 0; j <= rows; ++j)
  {
    for (int i = 0; i <= columns; ++i)
    {
      mesh.vertices_W.push_back(place(i, j));
    }
  }
  const auto across = static_cast<std::uint32_t>(columns) + 1;
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      const std::uint32_t a = first + static_cast<std::uint32_t>(j) * across + static_cast<std::uint32_t>(i);
      const std::uint32_t b = a + 1, c = b + across, d = a + across;
      const bool rising = random.below(2) == 0;
      mesh.triangles.push_back(rising ? std::array{ a, b, c } : std::array{ a, b, d });
      mesh.triangles.push_back(rising ? std::array{ a, c, d } : std::array{ b, c, d });
    }
  }
}

/// Around a tip in a closed ring, whose vertices are given.
void addFan(TriangleMesh& mesh, const Vec3& tip_W, const std::vector<Vec3>& ring_W)
{
  const auto first = static_cast<std::uint32_t>(mesh.vertices_W.size());
  const auto count = static_cast<std::uint32_t>(ring_W.size());
  mesh.vertices_W.push_back(tip_W);
  mesh.vertices_W.insert(mesh.vertices_W.end(), ring_W.begin(), ring_W.end());
  for (std::uint32_t i = 0; i < count; ++i)
  {
    mesh.triangles.push_back({ first, first + 1 + i, first + 1 + (i + 1) % count });
  }
}

std::vector<Vec3> ring(int count, double radius_u, double z_u)
{
  std::vector<Vec3> places;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2 * std::numbers::pi * i / count;
    places.emplace_back(radius_u * std::cos(angle), radius_u * std::sin(angle), z_u);
  }
  return places;
}

/// Two flanks that meet in the y axis at 0.01 to 120 degrees, with or without a floor below.
TriangleMesh crest(Random& random)
{
  const double half = 0.5 * degree * spreadEvenly10(random, -2, std::log10(120.0));
  const int along = 1 + static_cast<int>(random.below(6)), down = 1 + static_cast<int>(random.below(3));
  const double x = std::sin(half), z = -std::cos(half);
  TriangleMesh mesh;
  const auto y = [&](int i) { return 2.0 * i / along - 1.0; };
  for (const double side : { -1.0, 1.0 })
  {
    addGrid(mesh, along, down, random, [&](int i, int j) { return Vec3(side * x * j / down, y(i), z * j / down); });
  }
  if (random.below(2) == 0)
  {
    addGrid(mesh, along, 1, random, [&](int i, int j) { return Vec3(j == 0 ? -x : x, y(i), z); });
  }
  return mesh;
}

/// Half angles of 0.1 to 80 degrees; 3 to 40 sides; open or closed below.
TriangleMesh cone(Random& random)
{
  const double half = std::min(80 * degree, 0.1 * degree * spreadEvenly10(random, 0, 3));
  const int sides = 3 + static_cast<int>(random.below(random.below(2) == 0 ? 3 : 38));
  const std::vector<Vec3> base = ring(sides, std::sin(half), -std::cos(half));
  TriangleMesh mesh;
  addFan(mesh, Vec3::Zero(), base);
  if (random.below(2) == 0)
  {
    addFan(mesh, { 0, 0, -std::cos(half) }, base);
  }
  return mesh;
}

/// A closed ball with a spike on each of its faces.
TriangleMesh spikes(Random& random)
{
  const TriangleMesh ball = makeIcosphere(static_cast<int>(random.below(3)), 1.0);
  const double height_u = spreadEvenly10(random, -1, 1);
  TriangleMesh mesh;
  for (const auto& [a, b, c] : ball.triangles)
  {
    const Vec3 &va = ball.vertices_W[a], &vb = ball.vertices_W[b], &vc = ball.vertices_W[c];
    addFan(mesh, (1 + height_u) * (va + vb + vc) / 3, { va, vb, vc });
  }
  return scaled(mesh, 1 / (1 + height_u));
}

/// A thread of two to four turns whose flanks meet at 1 to 90 degrees, inside and outside.
TriangleMesh screw(Random& random)
{
  const int around = 2 * (3 + static_cast<int>(random.below(14))), turns = 2 + static_cast<int>(random.below(3));
  const double pitch_u = 1.0 / turns, half = 0.5 * degree * spreadEvenly10(random, 0, std::log10(90.0));
  const double depth_u = std::min(2.0, 0.5 * pitch_u / std::tan(half)), root_u = random.uniform(0.1, 1.0);
  TriangleMesh mesh;
  addGrid(mesh, around * turns, 2, random,
    [&](int i, int j)
    {
      const double angle = 2 * std::numbers::pi * (i % around) / around, r = root_u + (j == 1 ? depth_u : 0.0);
      return Vec3(r * std::cos(angle), r * std::sin(angle), pitch_u * (i + j * around / 2) / around);
    });
  return mesh;
}

/// 3 to 10,000 triangles round one vertex: flat, a cone either way, or zigzag.
TriangleMesh fan(Random& random)
{
  const double most = std::min<double>(10000.0, static_cast<double>(testTriangles(1000)));
  const int sides = static_cast<int>(spreadEvenly10(random, std::log10(3.0), std::log10(most)));
  std::vector<Vec3> rim = ring(sides, 1.0, 0.0);
  const double zigzag_u = random.below(3) == 0 ? spreadEvenly10(random, -3, 0) : 0.0;
  for (Vec3& v : rim)
  {
    v.z() = zigzag_u * random.uniform(-1, 1);
  }
  const double tip_u = random.below(3) == 0 ? 0.0 : spreadEvenly10(random, -3, 0.5);
  TriangleMesh mesh;
  addFan(mesh, { 0, 0, random.below(2) == 0 ? tip_u : -tip_u }, rim);
  return mesh;
}

/// Squares divided in four at random, each of the smallest two triangles: T-junctions exactly on the edges, for all
/// coordinates are multiples of 1/64. Flat, or folded in the y axis up to a crest of a degree.
void addSquare(TriangleMesh& mesh, double x, double y, double side, double slope, Random& random)
{
  if (side > 0.0625 && random.below(3) > 0)
  {
    for (const double up : { 0.0, side / 2 })
    {
      addSquare(mesh, x, y + up, side / 2, slope, random);
      addSquare(mesh, x + side / 2, y + up, side / 2, slope, random);
    }
    return;
  }
  addGrid(mesh, 1, 1, random,
    [&](int i, int j) { return Vec3(x + i * side, y + j * side, -slope * std::fabs(x + i * side)); });
}

TriangleMesh junctions(Random& random)
{
  const double slope = std::array{ 0.0, 0.25, 2.0, 16.0, 128.0 }[random.below(5)];
  TriangleMesh mesh;
  for (const double x : { -0.5, 0.0 })
  {
    for (const double y : { -0.5, 0.0 })
    {
      addSquare(mesh, x, y, 0.5, slope, random);
    }
  }
  return mesh;
}

/// Every triangle cut in three at a point that is 1e-2 to 1e-16 of it off one of its edges or corners.
TriangleMesh slivers(Random& random)
{
  TriangleMesh coarse = makeSheet({ 1, 1, 3, 3, 0.3 }, random);
  const double bump_u = random.below(2) == 0 ? 0.0 : 0.3;
  for (Vec3& v : coarse.vertices_W)
  {
    v.z() = bump_u * random.uniform(-1, 1);
  }
  TriangleMesh mesh;
  for (const auto& [a, b, c] : coarse.triangles)
  {
    const Vec3 &va = coarse.vertices_W[a], &vb = coarse.vertices_W[b], &vc = coarse.vertices_W[c];
    const double off = spreadEvenly10(random, -16, -2), along = random.below(3) == 0 ? off : random.uniform();
    addFan(mesh, va + along * (vb - va) + off * (vc - va), { va, vb, vc });
  }
  return mesh;
}

/// Whole numbers only: exact questions are answered without rounding.
TriangleMesh lattice(Random& random)
{
  const int height = static_cast<int>(random.below(4));
  TriangleMesh mesh;
  std::array<std::array<int, 7>, 7> z{};
  for (auto& row : z)
  {
    std::generate(
      row.begin(), row.end(), [&] { return static_cast<int>(random.below(static_cast<std::uint32_t>(height) + 1)); });
  }
  addGrid(mesh, 6, 6, random, [&](int i, int j) { return Vec3(i - 3, j - 3, z[j][i]); });
  return mesh;
}

/// The same with every fourth triangle left out: rims everywhere.
TriangleMesh rims(Random& random)
{
  TriangleMesh mesh = lattice(random);
  random.shuffle(mesh.triangles);
  mesh.triangles.resize(mesh.triangles.size() * 3 / 4);
  return mesh;
}

TriangleMesh sphere(Random& random)
{
  int levels = 2;
  for (std::size_t count = 20 * 64; count <= testTriangles(20480); count *= 4)
  {
    ++levels;
  }
  return makeIcosphere(levels - static_cast<int>(random.below(2)), 1.0);
}

TriangleMesh soup(Random& random)
{
  return makeSoup(60, 1.0, random);
}

template<TriangleMesh (*make)(Random&)>
TriangleMesh anywhere(Random& random)
{
  const TriangleMesh mesh = make(random);
  return random.below(2) == 0 ? mesh : Anywhere(random, 1.0)(mesh);
}

TriangleMesh scales(Random& random)
{
  const std::array makers = { crest, cone, lattice, junctions, spikes };
  const TriangleMesh mesh = makers[random.below(makers.size())](random);
  return scaled(mesh, spreadEvenly10(random, -30, 30));
}

} // namespace

const std::vector<Family>& families()
{
  static const std::vector<Family> all = { { "Crests", anywhere<crest> }, { "Cones", anywhere<cone> },
    { "Spikes", anywhere<spikes> }, { "Screws", anywhere<screw> }, { "Fans", anywhere<fan> },
    { "Junctions", anywhere<junctions> }, { "Slivers", anywhere<slivers> }, { "Lattices", anywhere<lattice> },
    { "Rims", anywhere<rims> }, { "Spheres", anywhere<sphere> }, { "Soups", anywhere<soup> }, { "Scales", scales } };
  return all;
}

} // namespace palpate::test
