// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <type_traits>

namespace palpate
{

/// The latest value from one writer thread to one reader thread; values in between are dropped.
/// Both sides are wait-free: one atomic exchange at most, no loop, no allocation. T is copied by assignment.
template<class T>
class TripleBuffer
{
  static_assert(std::is_copy_assignable_v<T>, "copied by assignment, which must not throw");

public:
  TripleBuffer() = default;
  explicit TripleBuffer(const T& initial) noexcept : slots_{ initial, initial, initial } {}

  /// Writer thread only; wait-free.
  void write(const T& value) noexcept
  {
    this->slots_[this->back_] = value;
    const std::uint8_t old =
      this->shared_.exchange(static_cast<std::uint8_t>(this->back_ | dirty), std::memory_order_acq_rel);
    this->back_ = old & indexMask;
  }

  /// Reader thread only; wait-free. The reference stays valid until the next read.
  [[nodiscard]] const T& read() noexcept
  {
    if (this->shared_.load(std::memory_order_relaxed) & dirty)
    {
      this->front_ = this->shared_.exchange(this->front_, std::memory_order_acq_rel) & indexMask;
    }
    return this->slots_[this->front_];
  }

private:
  static constexpr std::uint8_t indexMask = 3;
  static constexpr std::uint8_t dirty = 4;
  static_assert(std::atomic<std::uint8_t>::is_always_lock_free);

  std::array<T, 3> slots_{};
  alignas(64) std::atomic<std::uint8_t> shared_ = 1; ///< index of the middle slot, and whether it is news
  alignas(64) std::uint8_t back_ = 0;                ///< writer's
  alignas(64) std::uint8_t front_ = 2;               ///< reader's
};

} // namespace palpate
