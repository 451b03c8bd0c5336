// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <atomic>
#include <cstdint>
#include <thread>

#include <gtest/gtest.h>

#include "haptics/realtime/TripleBuffer.h"

namespace palpate
{
namespace
{

/// A record that shows when it was written in parts: every word holds the same number.
struct Record
{
  std::array<std::uint64_t, 24> words{};

  [[nodiscard]] bool whole() const
  {
    for (const std::uint64_t word : this->words)
    {
      if (word != this->words[0])
      {
        return false;
      }
    }
    return true;
  }
};

Record recordOf(std::uint64_t n)
{
  Record record;
  record.words.fill(n);
  return record;
}

TEST(TripleBuffer, GivesTheInitialValueBeforeTheFirstWrite)
{
  TripleBuffer<int> buffer(7);
  EXPECT_EQ(buffer.read(), 7);
}

TEST(TripleBuffer, GivesTheLatestOfSeveralWritesAndKeepsIt)
{
  TripleBuffer<int> buffer;
  buffer.write(1);
  buffer.write(2);
  EXPECT_EQ(buffer.read(), 2);
  EXPECT_EQ(buffer.read(), 2);
}

// Row 52: 3e6 reads against a writer that never rests.
TEST(TripleBuffer, NeverShowsATornOrAnOlderRecordInThreeMillionReads)
{
  constexpr int reads = 3'000'000;
  TripleBuffer<Record> buffer;
  std::atomic<bool> done = false;
  std::jthread writer(
    [&]
    {
      for (std::uint64_t n = 1; !done.load(std::memory_order_relaxed); ++n)
      {
        buffer.write(recordOf(n));
      }
    });
  std::uint64_t last = 0, torn = 0, backward = 0;
  for (int i = 0; i < reads; ++i)
  {
    const Record& record = buffer.read();
    torn += !record.whole();
    backward += record.words[0] < last;
    last = record.words[0];
  }
  done = true;
  EXPECT_EQ(torn, 0U);
  EXPECT_EQ(backward, 0U);
}

} // namespace
} // namespace palpate
