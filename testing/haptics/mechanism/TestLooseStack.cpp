// SPDX-License-Identifier: GPL-3.0-or-later
// Boxes on one another tip or slide where statics says.
#include <cmath>

#include <gtest/gtest.h>

#include "LooseScenes.h"

namespace palpate::test
{
namespace
{

class PushedStack : public testing::TestWithParam<int>
{
};

TEST_P(PushedStack, TipsOrSlidesWhereStaticsSays)
{
  const Stack::Limit limit = Stack().limitOf(GetParam());
  const StackMotion below = pushStack(GetParam(), 0.99), above = pushStack(GetParam(), 1.01);
  EXPECT_LE(below.most_m, 1e-5);
  EXPECT_LE(below.turned_rad, 1e-4);
  EXPECT_GT(above.along_m[static_cast<std::size_t>(GetParam())], 1e-3);
  EXPECT_EQ(above.turned_rad > 0.05, limit.tips) << above.turned_rad;
  if (!limit.tips && limit.from > 0)
  {
    EXPECT_LE(std::abs(above.along_m[static_cast<std::size_t>(limit.from - 1)]), 1e-5) << "the box below stays";
  }
}

INSTANTIATE_TEST_SUITE_P(Each, PushedStack, testing::Values(0, 1, 2));

} // namespace
} // namespace palpate::test
