// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces in cells of any shape. The judges are formulas: the plane of a linear function, which cells of every kind
// have exactly, and profiles of boundary layers.
#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "haptics/field/proxy/FieldProxy.h"
#include "haptics/recording/inputs/FieldBlocks.h"
#include "testing/support/AllocationGuard.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

constexpr double spring_N_per_u = 1.0;
constexpr double handStep_u = 0.012; ///< 0.3 m/s where 25 mm of the hand are one unit

using PointPlace = std::function<Vec3(double, double, double)>;

/// A block of hexahedra whose points are those of a function of their indices.
CellParts block(const GridIndex& points, const PointPlace& place)
{
  CellParts parts;
  const auto index = [&points](int i, int j, int k)
  { return static_cast<std::uint32_t>(i + points[0] * (j + points[1] * k)); };
  for (int k = 0; k < points[2]; ++k)
  {
    for (int j = 0; j < points[1]; ++j)
    {
      for (int i = 0; i < points[0]; ++i)
      {
        parts.points_W.push_back(place(i, j, k));
        if (i + 1 < points[0] && j + 1 < points[1] && k + 1 < points[2])
        {
          parts.corners.push_back({ index(i, j, k), index(i + 1, j, k), index(i, j + 1, k), index(i + 1, j + 1, k),
            index(i, j, k + 1), index(i + 1, j, k + 1), index(i, j + 1, k + 1), index(i + 1, j + 1, k + 1) });
        }
      }
    }
  }
  return parts;
}

/// Every hexahedron as other cells, of its own corners in the same order.
CellParts cutInto(CellParts parts, const std::vector<CellCorners>& pieces)
{
  std::vector<CellCorners> cut;
  for (const CellCorners& hexahedron : parts.corners)
  {
    for (CellCorners piece : pieces)
    {
      for (std::uint32_t& corner : piece)
      {
        corner = hexahedron[corner];
      }
      cut.push_back(piece);
    }
  }
  parts.corners = std::move(cut);
  return parts;
}

/// By the diagonal of two opposite faces, the same in every cell.
const std::vector<CellCorners> wedges{ { 0, 1, 3, 3, 4, 5, 7, 7 }, { 0, 3, 2, 2, 4, 7, 6, 6 } };
/// Kuhn's six, whose faces match from cell to cell.
const std::vector<CellCorners> tetrahedra{ { 0, 1, 3, 3, 7, 7, 7, 7 }, { 0, 1, 5, 5, 7, 7, 7, 7 },
  { 0, 2, 3, 3, 7, 7, 7, 7 }, { 0, 2, 6, 6, 7, 7, 7, 7 }, { 0, 4, 5, 5, 7, 7, 7, 7 }, { 0, 4, 6, 6, 7, 7, 7, 7 } };
/// Every hexahedron as six pyramids whose tips are its middle.
CellParts pyramids(const CellParts& parts)
{
  CellParts cut = parts;
  cut.corners.clear();
  for (const CellCorners& c : parts.corners)
  {
    const auto tip = static_cast<std::uint32_t>(cut.points_W.size());
    Vec3 middle = Vec3::Zero();
    for (const std::uint32_t corner : c)
    {
      middle += 0.125 * parts.points_W[corner];
    }
    cut.points_W.push_back(middle);
    for (const std::array<std::size_t, 4>& base : { std::array<std::size_t, 4>{ 0, 2, 4, 6 }, { 1, 3, 5, 7 },
           { 0, 1, 4, 5 }, { 2, 3, 6, 7 }, { 0, 1, 2, 3 }, { 4, 5, 6, 7 } })
    {
      cut.corners.push_back({ c[base[0]], c[base[1]], c[base[2]], c[base[3]], tip, tip, tip, tip });
    }
  }
  return cut;
}

template<class Function>
FieldBlock cellFieldBlock(CellParts parts, const Function& value)
{
  for (const Vec3& p_W : parts.points_W)
  {
    parts.values.push_back(static_cast<float>(value(p_W)));
  }
  Eigen::AlignedBox3d box;
  for (const Vec3& p_W : parts.points_W)
  {
    box.extend(p_W);
  }
  const FieldBlockGrid grid{ { 2, 2, 2 }, box.sizes(), { box.min() } };
  return { 1, grid, { { FieldBlockRole::Scalar, "f", std::vector<float>(8, 0.0F) } }, {}, {}, nullptr,
    FieldCells::make(std::move(parts)) };
}

struct CellHand
{
  FieldBlock brick;
  FieldPlan plan{};
  FieldState state{};
  FieldResult last{};

  explicit CellHand(FieldBlock felt, double isovalue) : brick(std::move(felt))
  {
    this->plan.isosurface = true;
    this->plan.isovalue = isovalue;
  }
  /// Where the proxy is then.
  Vec3 to(const Vec3& p_W)
  {
    this->last = moveFieldProxy(this->brick, this->plan, spring_N_per_u, p_W, this->state);
    return p_W + this->last.pull_W;
  }
};

TEST(FieldCells, OfEveryKindHoldAHandOnThePlaneOfALinearFunctionToRounding)
{
  test::Random random(test::testSeed(2801));
  std::vector<Vec3> jitter;
  for (int i = 0; i < 1000; ++i)
  {
    jitter.push_back(random.inCube(0.04));
  }
  const PointPlace place = [&](double i, double j, double k)
  {
    // Powers of two apart, so that numbers are floats; flat, skew and uneven, with straight edges alone.
    const auto at = static_cast<std::size_t>(i + 9 * (j + 9 * k));
    const Vec3 p = Vec3(i, 0.25 * j + 0.1 * i, 0.5 * k) + jitter[at % jitter.size()];
    return Vec3((p * 1024.0).array().round() / 1024.0);
  };
  const Vec3 slope(0.25, 1.0, 0.5);
  const auto linear = [&slope](const Vec3& p) { return slope.dot(p); };
  const Vec3 middle(4.0, 1.4, 2.0), n = slope.normalized();
  const CellParts hexahedra = block({ 9, 9, 9 }, place);
  for (const CellParts& parts :
    { hexahedra, cutInto(hexahedra, wedges), cutInto(hexahedra, tetrahedra), pyramids(hexahedra) })
  {
    CellHand hand(cellFieldBlock(parts, linear), linear(middle));
    hand.to(middle + 0.2 * n);
    for (int i = 0; i < 300; ++i)
    {
      const double turn = 0.05 * i;
      const Vec3 p = middle + Vec3(1.5 * std::sin(turn), 0.3 * std::sin(1.7 * turn), 0.8 * std::cos(1.3 * turn));
      const Vec3 beside = p - n.dot(p - middle) * n;
      for (int more = 0; more < 9; ++more)
      {
        hand.to(beside - 0.1 * n);
      }
      const Vec3 x = hand.to(beside - 0.1 * n);
      ASSERT_FALSE(hand.last.letGo) << i;
      ASSERT_LT((x - beside).norm(), 1e-5) << parts.corners.size() << " cells, tick " << i;
      ASSERT_GE(linear(x) - linear(middle), -1e-9) << "on its side";
    }
  }
}

/// Walls at y = 0 with cells that grow from 1e-3 to a third of the channel.
const std::vector<double>& heights()
{
  static const std::vector<double> all = []
  {
    std::vector<double> y{ 0.0 };
    for (double step = 1e-3; y.back() < 2.0; step *= 1.25)
    {
      y.push_back(y.back() + step);
    }
    return y;
  }();
  return all;
}

double layerProfile(double y)
{
  return 1.0 - std::exp(-y / 0.0127);
}

/// Where linear interpolation between the heights has a value, and how high the cell is.
std::array<double, 2> heightOf(double u)
{
  const std::vector<double>& y = heights();
  for (std::size_t j = 1;; ++j)
  {
    const double low = static_cast<float>(layerProfile(y[j - 1])), high = static_cast<float>(layerProfile(y[j]));
    if (high >= u)
    {
      return { y[j - 1] + (u - low) / (high - low) * (y[j] - y[j - 1]), y[j] - y[j - 1] };
    }
  }
}

TEST(FieldCells, OfAChannelHoldAHandAtEachSurfaceOfItsBoundaryLayerGoingThroughTheWallAndAlongIt)
{
  const CellParts parts = block({ 25, static_cast<int>(heights().size()), 13 },
    [](double i, double j, double k) { return Vec3(0.25 * i, heights()[static_cast<std::size_t>(j)], 0.25 * k); });
  for (const double u : { 0.5, 0.9, 0.99 })
  {
    const auto [surface, cell] = heightOf(u);
    ASSERT_NEAR(surface, -0.0127 * std::log(1.0 - u), 0.25 * cell) << "the data has it within a quarter of a cell";
    CellHand hand(cellFieldBlock(parts, [](const Vec3& p) { return layerProfile(p.y()); }), u);
    for (double y = 0.5; y > -0.2; y -= handStep_u)
    {
      const Vec3 x = hand.to({ 1.1, y, 1.4 });
      ASSERT_NEAR(x.y(), std::max(y, surface), 1e-3 * cell) << u << ", hand at " << y;
      ASSERT_GE(x.y(), surface - 1e-6 * cell) << "never through";
    }
    for (double way = 0.0; way < 3.0; way += handStep_u)
    {
      const Vec3 x = hand.to({ 1.1 + way, -0.2, 1.4 + 0.3 * std::sin(way) });
      ASSERT_NEAR(x.y(), surface, 1e-3 * cell) << u << ", after " << way;
      ASSERT_NEAR(x.x(), 1.1 + way, 2.0 * handStep_u) << "it comes along";
      ASSERT_GE(x.y(), surface - 1e-6 * cell);
    }
  }
}

TEST(FieldCells, OfAnOGridHoldAHandAllRoundASphereAcrossItsSeamAndPastItsPoles)
{
  constexpr int turns = 48, bends = 25, shells = 40;
  std::vector<double> radius{ 1.0 };
  for (double step = 2e-3; static_cast<int>(radius.size()) < shells; step *= 1.15)
  {
    radius.push_back(radius.back() + step);
  }
  const CellParts parts = block({ turns + 1, bends, shells },
    [&radius](double i, double j, double k)
    {
      const double turn = 2.0 * std::numbers::pi * i / turns, bend = std::numbers::pi * j / (bends - 1);
      return Vec3(radius[static_cast<std::size_t>(k)] *
                  Vec3(std::sin(bend) * std::cos(turn), std::sin(bend) * std::sin(turn), std::cos(bend)));
    });
  const double level = 1.0 - std::exp(-1.0);
  const auto speed = [](const Vec3& p) { return 1.0 - std::exp(-(p.norm() - 1.0) / 0.01); };
  const double chord = 1.0 - std::cos(std::numbers::pi / (bends - 1)); // a flat face is inside of its sphere
  CellHand hand(cellFieldBlock(parts, speed), level);
  const auto at = [](double turn, double bend)
  { return Vec3(std::sin(bend) * std::cos(turn), std::sin(bend) * std::sin(turn), std::cos(bend)); };
  for (const double bend : { 1.57, 0.5, 0.02 })
  {
    hand.state = FieldState{};
    hand.to(1.3 * at(-0.5, bend));
    for (double depth = 0.0; depth < 0.35; depth += handStep_u)
    {
      hand.to((1.3 - depth) * at(-0.5, bend));
    }
    for (double way = 0.0; way < 3.0; way += handStep_u)
    {
      const Vec3 n = at(-0.5 + way / std::max(0.2, std::sin(bend)), bend);
      const Vec3 x = hand.to(0.97 * n);
      ASSERT_FALSE(hand.last.letGo) << bend << ", after " << way;
      ASSERT_GE(x.norm(), (1.01 - 1e-3) * (1.0 - 2.0 * chord)) << bend << ", after " << way;
      ASSERT_LE(x.norm(), 1.01 + 1e-3) << bend << ", after " << way;
      ASSERT_LT((x.normalized() - n).norm(), 0.1) << "it comes along";
    }
  }
}

TEST(FieldCells, AreFeltToTheFaceOfACellThatIsHiddenAndToTheCellsOfAPointWithoutAValue)
{
  CellParts parts = block({ 9, 5, 5 }, [](double i, double j, double k) { return Vec3(i, j, k); });
  std::erase_if(parts.corners, [&](const CellCorners& c) { return parts.points_W[c[0]].x() >= 4.0; });
  const auto z = [](const Vec3& p) { return p == Vec3(1, 1, 1) ? std::nan("") : p.z(); };
  CellHand hand(cellFieldBlock(parts, z), 2.25);
  const auto isFelt = [&hand](double x, double y)
  {
    hand.state = FieldState{};
    hand.to({ x, y, 3.0 });
    return hand.to({ x, y, 2.0 }).z() > 2.2;
  };
  EXPECT_TRUE(isFelt(3.999, 1.5) && isFelt(2.001, 1.5) && isFelt(1.5, 2.001));
  EXPECT_FALSE(isFelt(4.001, 1.5));
  hand.plan.isovalue = 1.5;
  hand.state = FieldState{};
  hand.to({ 1.99, 1.5, 1.9 });
  EXPECT_TRUE(hand.last.outside) << "the cell has a corner without a value";
  hand.to({ 2.01, 1.5, 1.9 });
  EXPECT_FALSE(hand.last.outside);
}

TEST(FieldCells, GoOnInARecordingAsTheyWere)
{
  const CellParts parts =
    block({ 9, 9, 9 }, [](double i, double j, double k) { return Vec3(i, 0.25 * j, k + 0.1 * i); });
  CellHand hand(cellFieldBlock(parts, [](const Vec3& p) { return p.y() + 0.05 * std::sin(p.x() + p.z()); }), 1.1);
  hand.to({ 4, 1.5, 4 });
  hand.to({ 4, 0.9, 4 });
  ByteWriter out;
  putFieldBlock(out, hand.brick);
  ByteReader in(out.bytes().data(), out.bytes().size());
  const auto read = readFieldBlock(in);
  ASSERT_TRUE(read && in.ok() && in.left() == 0 && read->cells());
  EXPECT_EQ(read->contentHash(), hand.brick.contentHash());
  FieldState state = hand.state;
  state.surface.x_W = Vec3::Zero(); // it is not recorded
  keepCellsWithin({ read }, state);
  EXPECT_EQ(state.surface.x_W, hand.state.surface.x_W);
  for (int i = 0; i < 300; ++i)
  {
    const Vec3 p(4.0 + 0.01 * i, 0.9, 4.0 - 0.005 * i);
    const Vec3 pull_W = moveFieldProxy(*read, hand.plan, spring_N_per_u, p, state).pull_W;
    ASSERT_EQ(p + pull_W, hand.to(p)) << i;
  }
  state.surface.x.cell[0] = static_cast<int>(read->cells()->parts().corners.size());
  keepCellsWithin({ read }, state);
  EXPECT_EQ(state.brick, 0U) << "a cell that is not there is none of them";
  for (std::size_t cut = 1; cut < 40; ++cut)
  {
    ByteReader less(out.bytes().data(), out.bytes().size() - cut);
    static_cast<void>(readFieldBlock(less));
    EXPECT_FALSE(less.ok());
  }
}

TEST(FieldCells, AreComeToAndLeftWithoutAStepAndOnTheSameSide)
{
  const auto value = [](const Vec3& p) { return p.y() + 0.1 * std::sin(0.7 * p.x()); };
  CellParts parts = block({ 41, 17, 9 }, [](double i, double j, double k) { return Vec3(0.5 * i, 0.25 * j, k); });
  parts.centre_W = Vec3(10.0, 2.0, 4.0);
  parts.reach_u = 6.0;
  const FieldBlock near = cellFieldBlock(parts, value);
  const FieldBlockGrid grid{ { 81, 33, 33 }, Vec3(0.25, 0.125, 0.25), {} };
  std::vector<float> values;
  for (std::size_t i = 0; i < grid.points(); ++i)
  {
    const auto at = static_cast<int>(i);
    values.push_back(static_cast<float>(value(grid.toWorld(Vec3(at % 81, at / 81 % 33, at / (81 * 33))))));
  }
  CellHand hand(FieldBlock(1, grid, { { FieldBlockRole::Scalar, "f", values } }, {}, {}, nullptr, near.cells()), 2.0);
  hand.to({ 1.0, 2.5, 4.0 });
  Vec3 last = hand.to({ 1.0, 1.5, 4.0 });
  int taken = 0;
  std::uint64_t felt = hand.state.brick;
  for (double x = 1.0; x < 19.0; x += handStep_u)
  {
    const Vec3 now = hand.to({ x, 1.5, 4.0 });
    ASSERT_LE((now - last).norm(), 2.0 * handStep_u + 0.1) << x;
    ASSERT_NEAR(now.y(), 2.0 - 0.1 * std::sin(0.7 * now.x()), 0.02) << x;
    taken += hand.state.brick != felt ? 1 : 0;
    felt = hand.state.brick;
    last = now;
  }
  EXPECT_EQ(taken, 2) << "not to and fro";
}

TEST(FieldCells, AllocateNothing)
{
  test::Random random(test::testSeed(2802));
  CellHand hand(cellFieldBlock(block({ 9, 9, 9 }, [](double i, double j, double k) { return Vec3(i, 0.1 * j * j, k); }),
                  [](const Vec3& p) { return (p - Vec3(4, 3, 4)).norm(); }),
    2.0);
  const test::AllocationGuard guard;
  for (int i = 0; i < 300; ++i)
  {
    hand.to(Vec3(4, 3, 4) + random.inCube(5.0));
  }
  EXPECT_EQ(guard.allocations() + guard.frees() + guard.locks(), 0U);
}

} // namespace
} // namespace palpate
