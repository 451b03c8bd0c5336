// SPDX-License-Identifier: GPL-3.0-or-later
// Large arrays lie in large pages where the system has them, with the contents of any other array.
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/core/LargePages.h"

namespace palpate::test
{
namespace
{

/// True if the kernel has been asked for large pages behind this address. /proc/self/smaps has a line with the range of
/// each mapping, and later its flags, of which hg is that wish.
bool isAskedForAt(const void* address)
{
  std::ifstream maps("/proc/self/smaps");
  const auto at = reinterpret_cast<std::uintptr_t>(address);
  bool inside = false;
  for (std::string line; std::getline(maps, line);)
  {
    std::istringstream text(line);
    std::uintptr_t first = 0, last = 0;
    char dash = 0;
    if (text >> std::hex >> first >> dash >> last && dash == '-')
    {
      inside = first <= at && at < last;
    }
    else if (inside && line.starts_with("VmFlags:"))
    {
      return line.find(" hg") != std::string::npos;
    }
  }
  return false;
}

TEST(LargePages, HoldLargeArraysAndNoSmallOnes)
{
  const bool kernelHasThem = std::filesystem::exists("/sys/kernel/mm/transparent_hugepage/enabled");
  std::vector<double> large, small;
  reserveLarge(large, 8u << 20U); // 64 MB: no other allocation has left such a range behind
  resizeLarge(small, 1000);
  EXPECT_EQ(isAskedForAt(large.data() + (4u << 20U)), kernelHasThem);
  EXPECT_FALSE(isAskedForAt(small.data() + 500));
}

TEST(LargePages, KeepWhatAnArrayHas)
{
  for (const std::size_t count : { std::size_t{ 0 }, std::size_t{ 5 }, std::size_t{ 3 } << 20U })
  {
    std::vector<std::uint32_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0u);
    const std::vector<std::uint32_t> before = numbers;
    reserveLarge(numbers, 2 * count);
    EXPECT_EQ(numbers, before);
    EXPECT_EQ(numbers.capacity(), 2 * count);
    resizeLarge(numbers, count + count / 2);
    EXPECT_EQ(numbers.size(), count + count / 2);
    EXPECT_TRUE(std::equal(before.begin(), before.end(), numbers.begin()));
    const std::uint32_t* room = numbers.data();
    reserveLarge(numbers, count);
    resizeLarge(numbers, count);
    EXPECT_EQ(numbers, before);
    EXPECT_EQ(numbers.data(), room) << "an array that has the room stays where it is";
  }
}

} // namespace
} // namespace palpate::test
