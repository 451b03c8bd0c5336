// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "haptics/core/InTwo.h"
#include "haptics/core/LargePages.h"

namespace palpate
{

/// Entries put in order by a key: those of key k are entries[start[k] .. start[k + 1]).
template<class Entry>
struct Buckets
{
  std::vector<std::uint32_t> start;
  std::vector<Entry> entries;
};

/// A stable counting sort of fewer than 2^32 entries with keys below `keys`, that come in two parts, one for each
/// thread. `forEach(part, visit)` calls visit(key, entry) for each entry of part 0 or 1, the same each time. O(n +
/// keys).
template<class Entry, class ForEach>
[[nodiscard]] Buckets<Entry> makeBuckets(std::size_t keys, unsigned threads, const ForEach& forEach)
{
  std::array<std::vector<std::uint32_t>, 2> next;
  const auto count = [&](std::size_t part)
  {
    reserveLarge(next[part], keys);
    next[part].assign(keys, 0);
    forEach(part, [&of = next[part]](std::uint32_t key, const Entry&) { ++of[key]; });
  };
  inTwo(
    threads, [&] { count(0); }, [&] { count(1); });
  Buckets<Entry> buckets;
  resizeLarge(buckets.start, keys + 1);
  std::uint32_t sum = 0;
  for (std::size_t key = 0; key < keys; ++key)
  {
    buckets.start[key] = sum;
    for (std::vector<std::uint32_t>& of : next)
    {
      const std::uint32_t here = of[key];
      of[key] = sum;
      sum += here;
    }
  }
  buckets.start[keys] = sum;
  resizeLarge(buckets.entries, sum);
  const auto fill = [&](std::size_t part)
  {
    forEach(part, [&, &of = next[part]](std::uint32_t key, const Entry& entry) { buckets.entries[of[key]++] = entry; });
  };
  inTwo(
    threads, [&] { fill(0); }, [&] { fill(1); });
  return buckets;
}

/// Which of `count` things belong to part 0 or 1: [first, last).
struct Half
{
  std::size_t first, last;
};
[[nodiscard]] inline Half halfOf(std::size_t count, std::size_t part) noexcept
{
  return part == 0 ? Half{ 0, count / 2 } : Half{ count / 2, count };
}

} // namespace palpate
