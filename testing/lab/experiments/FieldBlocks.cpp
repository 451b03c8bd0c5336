// SPDX-License-Identifier: GPL-3.0-or-later
// FieldBlocks of tetrahedra and of images: how far their numbers are from the data's, their cost, and how fast a hand
// may go before it is at the rim of one that is made anew every so often.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "haptics/field/FieldBlock.h"
#include "haptics/field/build/Rasteriser.h"
#include "testing/lab/Experiments.h"
#include "testing/support/Fields.h"
#include "testing/support/Random.h"

namespace palpate::lab
{
namespace bricks_experiment
{

constexpr int brickPoints = 48;

/// Of the second derivatives none is larger than 1.
double waves(const Vec3& p)
{
  return std::sin(p.x()) * std::cos(p.y()) + 0.5 * std::sin(p.z());
}

constexpr double curvature = 2.5; ///< sum of the largest second derivatives of waves() along the axes

/// Cubes of an edge of 1 / cells of a box of 2, each cut into six tetrahedra.
struct Mesh
{
  std::vector<Vec3> points_W;
  std::vector<Tetrahedron> tetrahedra;
  std::vector<float> values;
  double edge = 0.0;
};

Mesh meshOf(int cells)
{
  constexpr std::uint32_t orders[6][3] = { { 0, 1, 2 }, { 1, 2, 0 }, { 2, 0, 1 }, { 0, 2, 1 }, { 2, 1, 0 },
    { 1, 0, 2 } };
  const auto side = static_cast<std::uint32_t>(cells + 1);
  const std::uint32_t strides[3] = { 1, side, side * side };
  Mesh mesh;
  mesh.edge = 2.0 / cells;
  for (std::uint32_t n = 0; n < side * side * side; ++n)
  {
    const std::array<std::uint32_t, 3> at{ n % side, n / side % side, n / side / side };
    mesh.points_W.push_back(mesh.edge * Vec3(at[0], at[1], at[2]) - Vec3::Ones());
    mesh.values.push_back(static_cast<float>(waves(mesh.points_W.back())));
    if (at[0] + 1 == side || at[1] + 1 == side || at[2] + 1 == side)
    {
      continue;
    }
    for (const auto& order : orders)
    {
      Tetrahedron corners{ n, 0, 0, 0 };
      for (std::size_t i = 0; i < 3; ++i)
      {
        corners[i + 1] = corners[i] + strides[order[i]];
      }
      mesh.tetrahedra.push_back(corners);
    }
  }
  return mesh;
}

/// The largest error of a block at places between its points, as far as its data reaches.
double errorOf(const FieldBlock& brick, test::Random& random)
{
  const double spacing = brick.grid().spacing_u.x();
  const double reach = std::min(0.5 * (brickPoints - 1) * spacing, 1.0 - 2.0 * spacing);
  double error = 0.0;
  for (int n = 0; n < 5000; ++n)
  {
    Vec3 p_W;
    for (double& at : p_W)
    {
      at = random.uniform(-reach, reach);
    }
    const auto found = brick.sample(FieldBlockRole::Scalar, p_W);
    error = std::max(error, found ? std::fabs(found->value - waves(p_W)) : 1.0);
  }
  return error;
}

FieldBlockGrid around(double spacing)
{
  return { { brickPoints, brickPoints, brickPoints }, Vec3::Constant(spacing),
    { Vec3::Constant(-0.5 * (brickPoints - 1) * spacing), Quat::Identity() } };
}

void judgeTetrahedra(const Mesh& mesh, int rounds, test::Random& random, Table& table)
{
  const TetraBins bins(mesh.points_W, mesh.tetrahedra);
  const TetraField field{ mesh.points_W, mesh.tetrahedra, mesh.values, 1 };
  for (const double share : { 0.25, 0.5, 1.0 })
  {
    const double spacing = share * mesh.edge;
    const FieldBlockGrid grid = around(spacing);
    test::CostSample cost(static_cast<std::size_t>(rounds));
    std::vector<float> values;
    for (int i = 0; i < rounds; ++i)
    {
      cost.time([&] { values = rasterise(field, bins, grid); });
    }
    const FieldBlock brick(1, grid, { { FieldBlockRole::Scalar, "f", values } });
    const std::string name = caseName({ { "tetrahedra", 1.0 * mesh.tetrahedra.size() }, { "share", share } });
    // Linear in a tetrahedron: an eighth of its longest edge squared, the cube's diagonal, times the largest second
    // derivative; between points of the block once more of theirs.
    const double cells = 3.0 * mesh.edge * mesh.edge / 8.0 * curvature, points = spacing * spacing / 8.0 * curvature;
    table.atMost({ name, "ours: tetrahedra", "error" }, errorOf(brick, random), cells + points + 1e-6).cost =
      Cost::of(cost);
  }
}

void judgeImage(double spacing, test::Random& random, Table& table)
{
  const FieldBlockGrid grid = around(spacing);
  const FieldBlock brick(1, grid,
    { { FieldBlockRole::Scalar, "f",
      test::sampledValues(grid.size, [&](const Vec3& i) { return waves(grid.toWorld(i)); }) } });
  table.atMost({ caseName({ { "spacing", spacing } }), "ours: image", "error" }, errorOf(brick, random),
    spacing * spacing / 8.0 * curvature + 1e-6);
}

/// Ticks of a millisecond in which a hand that goes straight on is outside of the block it has: the owner looks every
/// so often whether half of the margin is used up, and the next block, around where the hand was then, comes a while
/// later.
int ticksOutside(double speed_m_per_s, double room_m, int look_ms, int build_ms, int begin_ms)
{
  double centre_m = 0.0, next_m = 0.0;
  int ready_ms = -1, outside = 0;
  for (int t = 0; t < 2000; ++t)
  {
    const double hand_m = 1e-3 * speed_m_per_s * t;
    if (t == ready_ms)
    {
      centre_m = next_m;
      ready_ms = -1;
    }
    if ((t + begin_ms) % look_ms == 0 && ready_ms < 0 && hand_m - centre_m > 0.5 * room_m)
    {
      next_m = hand_m;
      ready_ms = t + build_ms;
    }
    outside += hand_m - centre_m > room_m ? 1 : 0;
  }
  return outside;
}

/// Half of the margin is left for the look and the work: v = room / 2 / (look + build).
void judgeSpeed(double room_m, int look_ms, int build_ms, Table& table)
{
  const double fastest_m_per_s = 0.5 * room_m / (1e-3 * (look_ms + build_ms));
  const auto outside = [&](double share)
  {
    int most = 0;
    for (int begin_ms = 0; begin_ms < look_ms; ++begin_ms)
    {
      most = std::max(most, ticksOutside(share * fastest_m_per_s, room_m, look_ms, build_ms, begin_ms));
    }
    return most;
  };
  const std::string name =
    caseName({ { "room_mm", 1e3 * room_m }, { "look_ms", 1.0 * look_ms }, { "build_ms", 1.0 * build_ms } });
  constexpr double below = 0.95, above = 1.2;
  table.info({ name, "bricks by distance", "fastest hand", "m/s" }, fastest_m_per_s);
  table.atMost({ name, "bricks by distance", "ticks outside just below that speed" }, outside(below), 0.0);
  table.atLeast({ name, "bricks by distance", "ticks outside above it" }, outside(above), 1.0);
}

} // namespace bricks_experiment

void runFieldBlocks(const Conditions& conditions, Table& table)
{
  using namespace bricks_experiment;
  test::Random random(conditions.seed);
  for (const int cells : conditions.pick(std::vector{ 16 }, std::vector{ 16, 32, 64 }, std::vector{ 16, 32, 64, 118 }))
  {
    judgeTetrahedra(meshOf(cells), conditions.pick(3, 5, 20), random, table);
  }
  for (const double spacing : { 0.01, 0.02, 0.04 })
  {
    judgeImage(spacing, random, table);
  }
  judgeSpeed(0.030, 40, 31, table); // a block of 48^3 of tetrahedra as large as 1.3 mm, looked after at 25 Hz
  judgeSpeed(0.060, 16, 100, table);
  judgeSpeed(0.120, 16, 5, table);
}

} // namespace palpate::lab
