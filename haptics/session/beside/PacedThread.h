// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <chrono>
#include <functional>
#include <thread>

#include "haptics/core/Clock.h"

namespace palpate
{

/// A thread beside the servo that does its work again and again. It ends before what it was made with does: keep it
/// last.
class PacedThread
{
public:
  static constexpr double idle_s = 0.05; ///< what a thread without work looks for some with

  /// Of a rate that a person asks for [s].
  [[nodiscard]] static double periodOf(double rate_Hz) noexcept { return 1.0 / std::max(rate_Hz, slowest_Hz); }

  /// `work`: once more; returns how long after its begin the next begins [s], or at once if it took longer.
  void begin(std::function<double()> work)
  {
    this->thread_ = std::jthread([work = std::move(work)](const std::stop_token& stop) { run(work, stop); });
  }
  [[nodiscard]] bool runs() const noexcept { return this->thread_.joinable(); }

private:
  static constexpr double slowest_Hz = 0.5;

  static void run(const std::function<double()>& work, const std::stop_token& stop)
  {
    const MonotonicClock clock;
    while (!stop.stop_requested())
    {
      const std::int64_t begin_ns = clock.now_ns();
      const double period_s = work();
      const double took_s = 1e-9 * static_cast<double>(clock.now_ns() - begin_ns);
      std::this_thread::sleep_for(std::chrono::duration<double>(std::max(period_s - took_s, 0.0)));
    }
  }

  std::jthread thread_;
};

} // namespace palpate
