// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdio>
#include <ctime>

#include <gtest/gtest.h>

#include "haptics/field/build/Rasteriser.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

/// A box of jittered cubes, each cut into six tetrahedra around its diagonal, so that faces match.
struct Mesh
{
  std::vector<Vec3> points_W;
  std::vector<Tetrahedron> tetrahedra;

  Mesh(int cubes, double jitter, test::Random& random)
  {
    const int points = cubes + 1;
    for (int i = 0; i < points * points * points; ++i)
    {
      const Vec3 at(i % points, i / points % points, i / points / points);
      const bool rim = (at.array() == 0.0).any() || (at.array() == cubes).any();
      this->points_W.push_back(rim ? at : Vec3(at + random.inCube(jitter)));
    }
    constexpr int ways[6][2] = { { 1, 3 }, { 3, 2 }, { 2, 6 }, { 6, 4 }, { 4, 5 }, { 5, 1 } };
    for (int i = 0; i < cubes * cubes * cubes; ++i)
    {
      const auto corner = [&](int c)
      {
        return static_cast<std::uint32_t>((i % cubes + (c & 1)) + points * ((i / cubes % cubes + (c >> 1 & 1)) +
                                                                             points * (i / cubes / cubes + (c >> 2))));
      };
      for (const auto& way : ways)
      {
        this->tetrahedra.push_back({ corner(0), corner(way[0]), corner(way[1]), corner(7) });
      }
    }
  }
};

template<class Function>
std::vector<float> valuesOf(const Mesh& mesh, const Function& function)
{
  std::vector<float> values;
  for (const Vec3& p_W : mesh.points_W)
  {
    values.push_back(static_cast<float>(function(p_W)));
  }
  return values;
}

/// The value by looking at every tetrahedron with areas of its own; NaN where there is none.
double slowly(const Mesh& mesh, const std::vector<float>& values, const Vec3& p_W)
{
  const auto volume = [](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
  { return (b - a).dot((c - a).cross(d - a)); };
  for (const Tetrahedron& t : mesh.tetrahedra)
  {
    const Vec3 c[4] = { mesh.points_W[t[0]], mesh.points_W[t[1]], mesh.points_W[t[2]], mesh.points_W[t[3]] };
    const double whole = volume(c[0], c[1], c[2], c[3]);
    const double share[4] = { volume(p_W, c[1], c[2], c[3]) / whole, volume(c[0], p_W, c[2], c[3]) / whole,
      volume(c[0], c[1], p_W, c[3]) / whole, volume(c[0], c[1], c[2], p_W) / whole };
    if (*std::min_element(share, share + 4) >= -1e-9)
    {
      return share[0] * values[t[0]] + share[1] * values[t[1]] + share[2] * values[t[2]] + share[3] * values[t[3]];
    }
  }
  return NAN;
}

FieldBlockGrid turnedGrid(double spacing, const Vec3& centre, int points)
{
  const Quat q(Eigen::AngleAxisd(0.6, Vec3(1, -2, 1).normalized()));
  return { { points, points, points }, Vec3(spacing, 1.2 * spacing, 0.9 * spacing),
    { centre - q * Vec3(spacing, 1.2 * spacing, 0.9 * spacing) * (0.5 * (points - 1)), q } };
}

TEST(Rasteriser, GivesTheValuesOfEveryTetrahedronAndNoneOutside)
{
  test::Random random(test::testSeed(1670));
  const Mesh mesh(6, 0.25, random);
  const std::vector<float> values = valuesOf(mesh, [](const Vec3& p) { return std::sin(p.x()) + p.y() * p.z(); });
  const TetraBins bins(mesh.points_W, mesh.tetrahedra);
  const FieldBlockGrid grid = turnedGrid(0.37, { 3.1, 2.9, 4.0 }, 16);
  const std::vector<float> raster = rasterise({ mesh.points_W, mesh.tetrahedra, values }, bins, grid);
  std::size_t inside = 0;
  for (std::size_t i = 0; i < raster.size(); ++i)
  {
    const Vec3 p_W = grid.toWorld(Vec3(i % 16, i / 16 % 16, i / 256));
    const double truth = slowly(mesh, values, p_W);
    ASSERT_EQ(std::isnan(truth), std::isnan(raster[i])) << p_W.transpose();
    inside += !std::isnan(truth);
    if (!std::isnan(truth))
    {
      EXPECT_NEAR(raster[i], truth, 4e-6 * 40.0);
    }
  }
  EXPECT_GT(inside, raster.size() / 4);
  EXPECT_LT(inside, raster.size()) << "some are outside";
}

TEST(Rasteriser, OfALinearFunctionIsExactInEveryComponentWhateverSizesAreBesideOneAnother)
{
  test::Random random(test::testSeed(1671));
  Mesh mesh(8, 0.0, random);
  for (Vec3& p_W : mesh.points_W)
  {
    p_W = p_W.array().pow(3).matrix() / 64.0; // edges from 1/64 to 2.6
  }
  std::vector<float> values;
  for (const Vec3& p_W : mesh.points_W)
  {
    values.push_back(static_cast<float>(p_W.x()));
    values.push_back(static_cast<float>(2.0 - p_W.z()));
  }
  const TetraBins bins(mesh.points_W, mesh.tetrahedra);
  const FieldBlockGrid grid{ { 20, 20, 20 }, Vec3::Constant(0.41), { Vec3::Constant(0.1) } };
  const std::vector<float> raster = rasterise({ mesh.points_W, mesh.tetrahedra, values, 2 }, bins, grid);
  for (std::size_t i = 0; i < grid.points(); ++i)
  {
    const Vec3 p_W = grid.toWorld(Vec3(i % 20, i / 20 % 20, i / 400));
    ASSERT_EQ((p_W.array() > 8.0).any(), std::isnan(raster[2 * i]));
    if (!std::isnan(raster[2 * i]))
    {
      EXPECT_NEAR(raster[2 * i], p_W.x(), 2e-6);
      EXPECT_NEAR(raster[2 * i + 1], 2.0 - p_W.z(), 2e-6);
    }
  }
}

TEST(Rasteriser, TakesInvertedTetrahedraAndLeavesOutThoseWithoutVolumeOrPlace)
{
  const std::vector<Vec3> points{ { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 0, 0, 4 }, { NAN, 0, 0 } };
  const std::vector<Tetrahedron> tetrahedra{ { 0, 2, 1, 3 }, { 0, 0, 1, 2 }, { 1, 1, 1, 1 }, { 0, 1, 2, 4 } };
  const std::vector<float> values{ 0, 4, 0, 0, 7 };
  const TetraBins bins(points, tetrahedra);
  const std::vector<float> raster =
    rasterise({ points, tetrahedra, values }, bins, { { 5, 5, 5 }, Vec3::Ones(), { Vec3::Zero() } });
  for (int i = 0; i < 125; ++i)
  {
    const int x = i % 5, y = i / 5 % 5, z = i / 25;
    ASSERT_EQ(x + y + z > 4, std::isnan(raster[i]));
    EXPECT_TRUE(std::isnan(raster[i]) || std::fabs(raster[i] - x) < 1e-6);
  }
}

TEST(Rasteriser, SaysWhatALargeMeshCosts)
{
  // 48^3 points at half an edge; 1e7 tetrahedra with PALPATE_TEST_TRIANGLES=10000000.
  const auto cubes = static_cast<int>(std::cbrt(static_cast<double>(test::testTriangles(160000)) / 6.0));
  test::Random random(test::testSeed(1672));
  const Mesh mesh(cubes, 0.2, random);
  const std::vector<float> values = valuesOf(mesh, [](const Vec3& p) { return p.norm(); });
  // The processor's time: others may be at work.
  const auto now_ms = [] { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; };
  const double begin_ms = now_ms();
  const TetraBins bins(mesh.points_W, mesh.tetrahedra);
  const double built_ms = now_ms();
  std::printf(
    "%zu tetrahedra: bins %.0f ms, %.1f MB;", mesh.tetrahedra.size(), built_ms - begin_ms, 1e-6 * bins.bytes());
  for (const double spacing : { 0.25, 0.5, 1.0 })
  {
    const FieldBlockGrid grid{ { 48, 48, 48 }, Vec3::Constant(spacing),
      { Vec3::Constant(0.5 * cubes - 23.5 * spacing) } };
    const double from_ms = now_ms();
    const std::vector<float> raster = rasterise({ mesh.points_W, mesh.tetrahedra, values }, bins, grid);
    std::printf(" h %.2f edges %.1f ms;", spacing, now_ms() - from_ms);
    EXPECT_EQ(raster.size(), grid.points());
  }
  std::printf("\n");
}

} // namespace
} // namespace palpate
