// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <thread>

#include <gtest/gtest.h>

#include "haptics/realtime/SpscRing.h"

namespace palpate
{
namespace
{

TEST(SpscRing, RefusesAndCountsWhatDoesNotFit)
{
  SpscRing<int, 4> ring;
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_TRUE(ring.tryPush(i));
  }
  EXPECT_FALSE(ring.tryPush(4));
  EXPECT_EQ(ring.refused(), 1U);
  int value = -1;
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_TRUE(ring.tryPop(value));
    EXPECT_EQ(value, i);
  }
  EXPECT_FALSE(ring.tryPop(value));
}

TEST(SpscRing, DeliversEveryValueInOrderBetweenTwoThreads)
{
  constexpr std::uint64_t count = 1'000'000;
  SpscRing<std::uint64_t, 1024> ring;
  std::jthread writer(
    [&ring]
    {
      for (std::uint64_t n = 0; n < count;)
      {
        if (ring.tryPush(n))
        {
          ++n;
        }
        else
        {
          std::this_thread::yield();
        }
      }
    });
  for (std::uint64_t expected = 0; expected < count;)
  {
    std::uint64_t value = 0;
    if (ring.tryPop(value))
    {
      ASSERT_EQ(value, expected);
      ++expected;
    }
    else
    {
      std::this_thread::yield();
    }
  }
}

} // namespace
} // namespace palpate
