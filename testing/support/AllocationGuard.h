// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace palpate::test
{

/// Counts heap allocations, frees and lock operations of the calling thread between construction and now, by taking the
/// place of malloc, operator new's allocator and the pthread lock functions in the test program. Under a sanitizer,
/// which takes their place itself, it counts nothing: a test that expects no count runs there all the same, for the
/// sanitizer to watch. Who reports a count or expects one asks works().
class AllocationGuard
{
public:
  AllocationGuard() noexcept;
  ~AllocationGuard();
  AllocationGuard(const AllocationGuard&) = delete;
  AllocationGuard& operator=(const AllocationGuard&) = delete;

  [[nodiscard]] std::uint64_t allocations() const noexcept;
  [[nodiscard]] std::uint64_t frees() const noexcept;
  [[nodiscard]] std::uint64_t locks() const noexcept;
  [[nodiscard]] static bool works() noexcept;
};

} // namespace palpate::test
