// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "haptics/realtime/RealtimeBroker.h"

namespace palpate
{

using RealtimeBrokers = std::vector<std::shared_ptr<RealtimeBroker>>;

/// Scheduling of the servo thread, and the reason where it is not real-time.
struct SchedulingReport
{
  bool realtime = false; ///< SCHED_FIFO or SCHED_RR was granted
  int priority = 0;      ///< 1..99 with one of these, else 0
  std::string message;   ///< the scheduling granted; if not real time, cause and cure
};

/// Steps of the acquisition, for the calling thread. Never abort; safe to repeat.
[[nodiscard]] Granted requestFifo(int wantedPriority);
[[nodiscard]] Granted requestNice();
[[nodiscard]] Granted requestTimerSlack();
[[nodiscard]] Granted requestShortSlice();
/// Lowers RLIMIT_RTTIME so that a real-time thread that runs 0.2 s without sleeping becomes an ordinary one (SIGXCPU)
/// before it can freeze the machine. Refused where the program handles SIGXCPU itself. Process-wide.
[[nodiscard]] Granted demoteRunaways();
/// Lowers RLIMIT_RTTIME further, its hard limit too, at which the kernel ends the program: brokers ask for that. A
/// runaway is demoted at half of it. Process-wide and, for an ordinary user, for good.
[[nodiscard]] Granted limitRealtimeRuns(std::int64_t longest_us);

/// Tries real-time scheduling for the calling thread within the limits granted to the user, then one broker after the
/// other. Where none grants it the thread keeps ordinary scheduling and asks for a nice value of -11, a timer slack of
/// 1 ns and a slice of 0.1 ms; the report says which of these were refused. Pre-faults the stack. Real-time scheduling
/// is asked for only once a runaway would be demoted.
[[nodiscard]] SchedulingReport acquireScheduling(
  int wantedPriority = 20, std::span<const std::shared_ptr<RealtimeBroker>> brokers = {});

/// A thread that first acquires its scheduling, then runs the body. Joined by the destructor.
class RealtimeThread
{
public:
  RealtimeThread() = default;
  /// `onScheduled` is called on the new thread before the body. Not real-time safe.
  RealtimeThread(std::function<void(const SchedulingReport&)> onScheduled, std::function<void(std::stop_token)> body,
    RealtimeBrokers brokers = {});

  void join();
  [[nodiscard]] bool joinable() const noexcept { return this->thread_.joinable(); }

private:
  std::jthread thread_;
};

} // namespace palpate
