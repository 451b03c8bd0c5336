// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace palpate
{

/// Asks the system for large pages behind memory that has not been written to yet. The first touch of each small page
/// is a call of the kernel: these calls took half of the making of a surface of a million triangles. Without effect
/// below 4 MB and on systems without large pages; the memory has the same contents either way.
void askForLargePages(void* memory, std::size_t bytes) noexcept;

/// Room for `count` entries, in large pages where the vector did not have that room yet.
template<class Entry>
void reserveLarge(std::vector<Entry>& of, std::size_t count)
{
  if (of.capacity() < count)
  {
    std::vector<Entry> fresh;
    fresh.reserve(count);
    askForLargePages(static_cast<void*>(fresh.data()), count * sizeof(Entry));
    fresh.insert(fresh.end(), of.begin(), of.end());
    of.swap(fresh);
  }
}

/// As `of.resize(count)`, in large pages.
template<class Entry>
void resizeLarge(std::vector<Entry>& of, std::size_t count)
{
  reserveLarge(of, count);
  of.resize(count);
}

} // namespace palpate
