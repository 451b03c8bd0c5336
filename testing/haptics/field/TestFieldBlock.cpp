// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "haptics/field/FieldBlock.h"
#include "testing/support/Fields.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

const GridIndex size{ 5, 6, 7 };

FieldBlockGrid turnedGrid()
{
  return { size, { 0.5, 2.0, 1.25 }, { { 10, -20, 30 }, Quat(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized())) } };
}

/// A function that a cell holds exactly: a term for each product of axes, with small whole numbers as weights.
double product(const Vec3& t)
{
  return 1 + 2 * t.x() - 3 * t.y() + 4 * t.z() + 5 * t.x() * t.y() - 6 * t.y() * t.z() + 7 * t.z() * t.x() +
         8 * t.x() * t.y() * t.z();
}

Vec3 gradientOfProduct(const Vec3& t)
{
  return { 2 + 5 * t.y() + 7 * t.z() + 8 * t.y() * t.z(), -3 + 5 * t.x() - 6 * t.z() + 8 * t.z() * t.x(),
    4 - 6 * t.y() + 7 * t.x() + 8 * t.x() * t.y() };
}

TEST(FieldBlock, GivesValueAndGradientOfATrilinearFunctionEverywhereInATurnedGridOfUnevenSpacing)
{
  const FieldBlockGrid grid = turnedGrid();
  const FieldBlock brick(1, grid, { { FieldBlockRole::Scalar, "f", test::sampledValues(size, product) } });
  test::Random random(test::testSeed(1601));
  for (std::size_t i = 0; i < test::testCount(300); ++i)
  {
    const Vec3 index(random.uniform(0, 4), random.uniform(0, 5), random.uniform(0, 6));
    const std::optional<FieldSample> sample = brick.sample(FieldBlockRole::Scalar, grid.toWorld(index));
    ASSERT_TRUE(sample);
    EXPECT_NEAR(sample->value, product(index), 1e-10);
    // The chain rule: index = R' (p - p0) / h.
    const Vec3 gradient_W = grid.pose_W.q.toRotationMatrix() * gradientOfProduct(index).cwiseQuotient(grid.spacing_u);
    EXPECT_LT((sample->gradient_W - gradient_W).norm(), 1e-10 * gradient_W.norm() + 1e-10);
  }
}

TEST(FieldBlock, OfValuesLessAnOffsetIsFeltAsOneOfTheValuesWhereTheseAreExact)
{
  constexpr double offset = 4096.0; // with the values below, whole numbers that single precision holds
  const FieldBlockGrid grid = turnedGrid();
  const FieldBlock plain(1, grid,
    { { FieldBlockRole::Scalar, "f", test::sampledValues(size, [](const Vec3& i) { return offset + product(i); }) } });
  const FieldBlock less(1, grid, { { FieldBlockRole::Scalar, "f", test::sampledValues(size, product), offset } });
  EXPECT_NE(less.contentHash(),
    FieldBlock(1, grid, { { FieldBlockRole::Scalar, "f", test::sampledValues(size, product) } }).contentHash());
  const FieldBlockComponent one = plain.component(FieldBlockRole::Scalar),
                            other = less.component(FieldBlockRole::Scalar);
  EXPECT_EQ(one.at({ 3, 2, 5 }), other.at({ 3, 2, 5 }));
  EXPECT_EQ(one.cell({ 1, 4, 3 }, 4100.0, -1.0).corner, other.cell({ 1, 4, 3 }, 4100.0, -1.0).corner);
  EXPECT_EQ(
    FieldBlock::refuse(grid, { { FieldBlockRole::Scalar, "f", test::sampledValues(size, product), NAN } }).empty(),
    false);
}

TEST(FieldBlock, HasTheMixedSecondDerivativesOfItsPolynomial)
{
  TrilinearCell cell;
  for (int i = 0; i < 8; ++i)
  {
    cell.corner[i] = product({ double(i & 1), double(i >> 1 & 1), double(i >> 2) });
  }
  const Vec3 t(0.3, 0.6, 0.9);
  EXPECT_LT((cell.mixed(t) - Vec3(-6 + 8 * t.x(), 7 + 8 * t.y(), 5 + 8 * t.z())).norm(), 1e-13);
}

TEST(FieldBlock, HasTheSameBitsOnAFaceFromBothOfItsCells)
{
  test::Random random(test::testSeed(1602));
  const auto brick = test::scalarFieldBlock(6, [&](const Vec3&) { return random.uniform(-1, 1); });
  const FieldBlockComponent f = brick->component(FieldBlockRole::Scalar);
  for (std::size_t i = 0; i < test::testCount(1000); ++i)
  {
    const int axis = static_cast<int>(random.below(3));
    GridIndex cell{ int(random.below(4)), int(random.below(4)), int(random.below(4)) };
    Vec3 t(random.uniform(), random.uniform(), random.uniform());
    t[axis] = 1.0;
    const double below = f.cell(cell).value(t);
    ++cell[axis];
    t[axis] = 0.0;
    EXPECT_EQ(below, f.cell(cell).value(t));
  }
}

TEST(FieldBlock, HasNoValueOutsideNorBesideAPointWithoutOneAndTakesInfinityForNone)
{
  const FieldBlockGrid grid{ size };
  std::vector<float> values = test::sampledValues(size, product);
  values[0] = std::numeric_limits<float>::quiet_NaN();
  values.back() = std::numeric_limits<float>::infinity();
  const FieldBlock brick(1, grid, { { FieldBlockRole::Scalar, "f", values } });
  EXPECT_FALSE(brick.sample(FieldBlockRole::Scalar, { 0.9, 0.9, 0.9 }));
  EXPECT_TRUE(brick.sample(FieldBlockRole::Scalar, { 1.1, 0.9, 0.9 }));
  EXPECT_FALSE(brick.sample(FieldBlockRole::Scalar, { 3.5, 4.5, 5.5 }));
  EXPECT_TRUE(brick.sample(FieldBlockRole::Scalar, { 4, 2, 2 })) << "the far face belongs to it";
  for (const Vec3& outside : { Vec3(-1e-9, 2, 2), Vec3(4 + 1e-9, 2, 2), Vec3(1e300, 2, 2), Vec3(2, -1e300, 2) })
  {
    EXPECT_FALSE(brick.sample(FieldBlockRole::Scalar, outside)) << outside.transpose();
  }
  EXPECT_FALSE(brick.sample(FieldBlockRole::Other, { 2, 2, 2 })) << "there is no such array";
}

TEST(FieldBlock, GivesAVectorInTheAxesOfTheWorld)
{
  const FieldBlock brick(1, { size },
    { { FieldBlockRole::Vector, "v",
      test::sampledVectors(size, [](const Vec3& i) { return Vec3(i.y(), -i.x(), 2); }) } });
  EXPECT_LT((*brick.vector({ 1.5, 2.25, 3 }) - Vec3(2.25, -1.5, 2)).norm(), 1e-12);
  EXPECT_FALSE(brick.vector({ -1, 0, 0 }));
}

TEST(FieldBlock, RefusesWhatIsNoFieldInOneLine)
{
  const std::vector<float> values(5 * 6 * 7);
  const auto refusal = [](const FieldBlockGrid& grid, const std::vector<FieldBlockArray>& arrays)
  { return FieldBlock::refuse(grid, arrays); };
  const FieldBlockArray scalar{ FieldBlockRole::Scalar, "f", values };
  EXPECT_EQ(refusal({ size }, { scalar }), "");
  EXPECT_NE(refusal({ { 5, 1, 7 } }, { { FieldBlockRole::Scalar, "f", std::vector<float>(35) } }), "") << "a plane";
  EXPECT_NE(refusal({ size, { 1, 0, 1 } }, { scalar }), "");
  EXPECT_NE(refusal({ size, { 1, -1, 1 } }, { scalar }), "");
  EXPECT_NE(refusal({ size, { 1, std::nan(""), 1 } }, { scalar }), "");
  EXPECT_NE(refusal({ size }, { { FieldBlockRole::Vector, "v", values } }), "")
    << "one component where three are needed";
  EXPECT_NE(refusal({ size }, { scalar, scalar }), "") << "two for one role";
  EXPECT_NE(FieldBlock::refuse({ size }, { scalar }, 100), "") << "more than may be used";
  EXPECT_EQ(FieldBlock::refuse({ size }, { scalar }, sizeof(float) * values.size()), "");
}

TEST(FieldBlock, IsNamedByItsContent)
{
  std::vector<float> values = test::sampledValues(size, product);
  const auto hash = [&](const FieldBlockGrid& grid) {
    return FieldBlock(1, grid, { { FieldBlockRole::Scalar, "", values } }).contentHash();
  };
  const std::uint64_t before = hash({ size });
  EXPECT_EQ(before, hash({ size }));
  EXPECT_NE(before, hash({ size, { 1, 1, 1.5 } }));
  values[17] += 1;
  EXPECT_NE(before, hash({ size }));
}

} // namespace
} // namespace palpate
