// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace palpate
{

/// One wake-up of a periodic loop.
struct Wakeup
{
  std::int64_t due_ns = 0;      ///< when the period began
  std::int64_t lateness_ns = 0; ///< how much later the thread ran, >= 0
  std::uint64_t missed = 0;     ///< periods that passed unseen since the last wake-up: skipped, never caught up
};

/// The clock that paces the servo: the wall clock, or a virtual one in tests.
class TickTimer
{
public:
  virtual ~TickTimer() = default;
  /// Waits for the next period. Servo thread.
  virtual Wakeup wait() noexcept = 0;
  /// Now, on the timer's own time line [ns].
  [[nodiscard]] virtual std::int64_t now_ns() const noexcept = 0;
};

/// Periods on CLOCK_MONOTONIC, slept towards in absolute time (clock_nanosleep with TIMER_ABSTIME: the standard
/// library's sleep_until reads the clock and then sleeps relatively). Periods returned plus periods missed equal
/// periods elapsed since the first.
class PeriodicTimer final : public TickTimer
{
public:
  explicit PeriodicTimer(std::int64_t period_ns) noexcept;
  Wakeup wait() noexcept override;
  [[nodiscard]] std::int64_t now_ns() const noexcept override;

private:
  std::int64_t period_ns_;
  std::int64_t next_ns_ = 0; ///< 0: not started
};

/// Periods that pass as fast as they are asked for; a test may make one late.
class VirtualTimer final : public TickTimer
{
public:
  explicit VirtualTimer(std::int64_t period_ns) noexcept : period_ns_(period_ns) {}
  /// The next wake-up comes this much later than it is due.
  void delayNext(std::int64_t lateness_ns) noexcept { this->delay_ns_ = lateness_ns; }
  Wakeup wait() noexcept override;
  [[nodiscard]] std::int64_t now_ns() const noexcept override { return this->now_ns_; }

private:
  std::int64_t period_ns_;
  std::int64_t next_ns_ = 0;
  std::int64_t now_ns_ = 0;
  std::int64_t delay_ns_ = 0;
};

} // namespace palpate
