// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace palpate
{

/// Every value from one writer thread to one reader thread, in order, up to Capacity at a time.
/// Both sides are wait-free; a push into a full ring is refused and counted, never blocks.
template<class T, std::size_t Capacity>
class SpscRing
{
  static_assert(std::is_copy_assignable_v<T>, "copied by assignment, which must not throw");
  static_assert((Capacity & (Capacity - 1)) == 0, "a power of two");
  static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

public:
  /// Writer thread only; wait-free. False if full: the value is not stored, refused() counts it.
  bool tryPush(const T& value) noexcept
  {
    const std::uint64_t head = this->head_.load(std::memory_order_relaxed);
    if (head - this->tail_.load(std::memory_order_acquire) == Capacity)
    {
      this->refused_.store(this->refused_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
      return false;
    }
    this->slots_[head % Capacity] = value;
    this->head_.store(head + 1, std::memory_order_release);
    return true;
  }

  /// Reader thread only; wait-free. False if empty.
  bool tryPop(T& value) noexcept
  {
    const std::uint64_t tail = this->tail_.load(std::memory_order_relaxed);
    if (tail == this->head_.load(std::memory_order_acquire))
    {
      return false;
    }
    value = this->slots_[tail % Capacity];
    this->tail_.store(tail + 1, std::memory_order_release);
    return true;
  }

  /// How many values were refused so far. Any thread.
  [[nodiscard]] std::uint64_t refused() const noexcept { return this->refused_.load(std::memory_order_relaxed); }

private:
  std::array<T, Capacity> slots_{};
  alignas(64) std::atomic<std::uint64_t> head_ = 0;
  alignas(64) std::atomic<std::uint64_t> tail_ = 0;
  alignas(64) std::atomic<std::uint64_t> refused_ = 0;
};

} // namespace palpate
