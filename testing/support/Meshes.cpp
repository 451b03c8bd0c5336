// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/support/Meshes.h"
#include "haptics/core/PoseMath.h"

#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <stdexcept>

#include "haptics/geometry/scene/SceneBuilder.h"
#include "testing/support/Icosahedron.h"

namespace palpate::test
{
namespace
{

using Triangle = std::array<std::uint32_t, 3>;

std::uint32_t addVertex(TriangleMesh& mesh, const Vec3& v)
{
  mesh.vertices_W.push_back(v);
  return static_cast<std::uint32_t>(mesh.vertices_W.size() - 1);
}

/// Divides every triangle in four; new vertices go onto the unit sphere.
TriangleMesh subdivided(const TriangleMesh& coarse)
{
  TriangleMesh fine{ coarse.vertices_W, {} };
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b)
  {
    const auto [at, isNew] = middles.try_emplace({ std::min(a, b), std::max(a, b) }, 0);
    if (isNew)
    {
      at->second = addVertex(fine, (fine.vertices_W[a] + fine.vertices_W[b]).normalized());
    }
    return at->second;
  };
  for (const auto& [a, b, c] : coarse.triangles)
  {
    const std::uint32_t x = middle(a, b), y = middle(b, c), z = middle(c, a);
    for (const Triangle& t : { Triangle{ a, x, z }, Triangle{ x, b, y }, Triangle{ z, y, c }, Triangle{ x, y, z } })
    {
      fine.triangles.push_back(t);
    }
  }
  return fine;
}

Vec3 sheetVertex(const Tessellation& how, int i, int j, Random& random)
{
  const bool inner = i > 0 && i < how.columns && j > 0 && j < how.rows;
  const double x = i + (inner ? how.jitter * random.uniform(-1, 1) : 0.0);
  const double y = j + (inner ? how.jitter * random.uniform(-1, 1) : 0.0);
  return { how.width_u * (x / how.columns - 0.5), how.height_u * (y / how.rows - 0.5), 0.0 };
}

} // namespace

TriangleMesh makeBox(const Vec3& low_W, const Vec3& high_W)
{
  TriangleMesh box;
  for (int corner = 0; corner < 8; ++corner)
  {
    box.vertices_W.emplace_back(
      (corner & 1 ? high_W : low_W).x(), (corner & 2 ? high_W : low_W).y(), (corner & 4 ? high_W : low_W).z());
  }
  box.triangles = { { 0, 2, 1 }, { 1, 2, 3 }, { 4, 5, 6 }, { 5, 7, 6 }, { 0, 1, 4 }, { 1, 5, 4 }, { 2, 6, 3 },
    { 3, 6, 7 }, { 0, 4, 2 }, { 2, 4, 6 }, { 1, 3, 5 }, { 3, 7, 5 } };
  return box;
}

TriangleMesh makeIcosphere(int levels, double radius_u)
{
  TriangleMesh mesh = icosahedron();
  for (int level = 0; level < levels; ++level)
  {
    mesh = subdivided(mesh);
  }
  return scaled(mesh, radius_u);
}

TriangleMesh makeSheet(const Tessellation& how, Random& random)
{
  TriangleMesh sheet;
  for (int j = 0; j <= how.rows; ++j)
  {
    for (int i = 0; i <= how.columns; ++i)
    {
      sheet.vertices_W.push_back(sheetVertex(how, i, j, random));
    }
  }
  for (int j = 0; j < how.rows; ++j)
  {
    for (int i = 0; i < how.columns; ++i)
    {
      const auto a = static_cast<std::uint32_t>(j * (how.columns + 1) + i), b = a + 1;
      const std::uint32_t d = a + static_cast<std::uint32_t>(how.columns) + 1, c = d + 1;
      const bool rising = random.below(2) == 0;
      sheet.triangles.push_back(rising ? Triangle{ a, b, c } : Triangle{ a, b, d });
      sheet.triangles.push_back(rising ? Triangle{ a, c, d } : Triangle{ b, c, d });
    }
  }
  return sheet;
}

TriangleMesh makePlane(const Vec3& normal, double half_u, int cells, Random& random)
{
  const TriangleMesh flat = makeSheet({ 2 * half_u, 2 * half_u, cells, cells, 0.3 }, random);
  return rotated(flat, shortestTurn(Vec3::UnitZ(), normal));
}

TriangleMesh makeGroove(double halfAngle_rad, double size_u)
{
  const double x = size_u * std::sin(halfAngle_rad), z = size_u * std::cos(halfAngle_rad);
  TriangleMesh groove;
  groove.vertices_W = { { 0, -size_u, 0 }, { 0, size_u, 0 }, { x, -size_u, z }, { x, size_u, z }, { -x, -size_u, z },
    { -x, size_u, z } };
  groove.triangles = { { 0, 2, 1 }, { 1, 2, 3 }, { 0, 1, 4 }, { 1, 5, 4 } };
  return groove;
}

TriangleMesh makeCracked(double gap_m, Random& random)
{
  TriangleMesh mesh = shifted(makeSheet({ 0.04, 0.04, 7, 7, 0.3 }, random), { -0.02 - gap_m / 2, 0, 0 });
  append(mesh, shifted(makeSheet({ 0.04, 0.04, 5, 9, 0.3 }, random), { 0.02 + gap_m / 2, 0, 0 }));
  return mesh;
}

TriangleMesh makeFin()
{
  return { { { -1, -1, 0 }, { 0, -1, 0 }, { 0, 1, 0 }, { -1, 1, 0 }, { 1, -1, 0 }, { 1, 1, 0 }, { 0, -1, 1 },
             { 0, 1, 1 } },
    { { 0, 1, 2 }, { 0, 2, 3 }, { 1, 4, 5 }, { 1, 5, 2 }, { 1, 2, 6 }, { 2, 7, 6 } } };
}

TriangleMesh makeSoup(std::size_t count, double half_u, Random& random)
{
  TriangleMesh soup;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Vec3 a = random.inCube(half_u);
    const Vec3 b = a + random.inCube(0.4 * half_u);
    const bool sliver = i % 3 == 2;
    const Vec3 c = sliver ? Vec3(a + random.uniform() * (b - a) + random.inCube(1e-6 * half_u))
                          : Vec3(a + random.inCube(0.4 * half_u));
    const std::uint32_t first = addVertex(soup, a);
    addVertex(soup, b);
    addVertex(soup, c);
    soup.triangles.push_back({ first, first + 1, first + 2 });
  }
  return soup;
}

TriangleMesh scaled(const TriangleMesh& mesh, double factor)
{
  TriangleMesh result = mesh;
  for (Vec3& v : result.vertices_W)
  {
    v *= factor;
  }
  return result;
}

TriangleMesh unwelded(const TriangleMesh& mesh)
{
  TriangleMesh soup;
  for (const auto& triangle : mesh.triangles)
  {
    const auto first = static_cast<std::uint32_t>(soup.vertices_W.size());
    for (const std::uint32_t corner : triangle)
    {
      soup.vertices_W.push_back(mesh.vertices_W[corner]);
    }
    soup.triangles.push_back({ first, first + 1, first + 2 });
  }
  return soup;
}

TriangleMesh shifted(const TriangleMesh& mesh, const Vec3& by_W)
{
  TriangleMesh result = mesh;
  for (Vec3& v : result.vertices_W)
  {
    v += by_W;
  }
  return result;
}

TriangleMesh rotated(const TriangleMesh& mesh, const Quat& q)
{
  TriangleMesh result = mesh;
  for (Vec3& v : result.vertices_W)
  {
    v = q * v;
  }
  return result;
}

TriangleMesh shuffled(const TriangleMesh& mesh, Random& random)
{
  std::vector<std::uint32_t> place(mesh.vertices_W.size());
  std::iota(place.begin(), place.end(), 0u);
  random.shuffle(place);
  TriangleMesh result = mesh;
  for (std::size_t i = 0; i < place.size(); ++i)
  {
    result.vertices_W[place[i]] = mesh.vertices_W[i];
  }
  for (Triangle& t : result.triangles)
  {
    t = { place[t[0]], place[t[1]], place[t[2]] };
    std::swap(t[random.below(3)], t[random.below(3)]);
  }
  random.shuffle(result.triangles);
  return result;
}

TriangleMesh withDefects(const TriangleMesh& mesh, Random& random)
{
  TriangleMesh result = mesh;
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::uint32_t lost = addVertex(result, { nan, 0, 0 });
  for (std::uint32_t i = 0; i < count; ++i)
  {
    const auto [a, b, c] = mesh.triangles[random.below(count)];
    switch (i % 4)
    {
      case 0:
        result.triangles.insert(result.triangles.end(), 5, { a, b, c });
        break;
      case 1:
        result.triangles.push_back({ c, b, a });
        break;
      case 2:
        result.triangles.push_back({ a, b, b });
        break;
      default:
        result.triangles.push_back({ a, b, lost });
    }
  }
  return shuffled(result, random);
}

std::shared_ptr<const Scene> sceneOf(const TriangleMesh& mesh)
{
  SceneBuilder builder;
  SceneBuildResult built = builder.build({ { "surface", std::make_shared<TriangleMesh>(mesh), {} } });
  if (!built.scene)
  {
    throw std::runtime_error("mesh refused: " + built.reports.at(0).refusal);
  }
  return built.scene;
}

} // namespace palpate::test
