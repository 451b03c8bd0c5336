// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace palpate
{

inline constexpr std::int64_t perMs_ns = 1000000;

/// Source of time for everything around the tick; the tick itself never asks a clock.
class Clock
{
public:
  virtual ~Clock() = default;
  /// Monotonic time [ns].
  [[nodiscard]] virtual std::int64_t now_ns() const noexcept = 0;
};

/// CLOCK_MONOTONIC. Any thread, wait-free.
class MonotonicClock final : public Clock
{
public:
  [[nodiscard]] std::int64_t now_ns() const noexcept override;
};

} // namespace palpate
