// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "haptics/field/UsualGradient.h"
#include "testing/support/Fields.h"

namespace palpate
{
namespace
{

const GridIndex slab_n{ 9, 20, 33 };
const FieldBlockGrid grid{ slab_n, { 0.5, 2.0, 1.25 }, {} };

FieldBlock brickOf(const std::function<double(const Vec3&)>& f)
{
  return { 1, grid,
    { { FieldBlockRole::Scalar, "f",
      test::sampledValues(slab_n, [&](const Vec3& index) { return f(grid.toWorld(index)); }) } } };
}

TEST(UsualGradient, OfALinearFunctionIsItsSlope)
{
  const Vec3 slope(1.0, -2.0, 3.0);
  EXPECT_NEAR(usualGradient(brickOf([&](const Vec3& p_W) { return slope.dot(p_W); })), slope.norm(), 1e-5);
}

TEST(UsualGradient, IsThatOfTheCellsThatHaveValues)
{
  const auto half = [](const Vec3& p_W)
  { return p_W.z() < 20.0 ? 5.0 * p_W.x() : std::numeric_limits<double>::quiet_NaN(); };
  EXPECT_NEAR(usualGradient(brickOf(half)), 5.0, 1e-5);
  EXPECT_EQ(usualGradient(brickOf([](const Vec3&) { return std::numeric_limits<double>::quiet_NaN(); })), 0.0);
}

} // namespace
} // namespace palpate
