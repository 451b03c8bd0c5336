// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/core/LargePages.h"

#include <cstdint>

#include <sys/mman.h>
#include <unistd.h>

namespace palpate
{
namespace
{

/// Two large pages of x86-64: in less memory hardly one has room.
constexpr std::size_t leastBytes = std::size_t{ 4 } << 20U;

} // namespace

void askForLargePages(void* memory, std::size_t bytes) noexcept
{
#ifdef MADV_HUGEPAGE
  if (memory == nullptr || bytes < leastBytes)
  {
    return;
  }
  const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  const auto address = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t first = (address + page - 1) / page * page, last = (address + bytes) / page * page;
  (void)madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE); // only asked for
#else
  (void)memory;
  (void)bytes;
#endif
}

} // namespace palpate
