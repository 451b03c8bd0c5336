// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <thread>

namespace palpate
{

/// One system call that may be refused: whether it was granted, and a sentence for a person.
struct Granted
{
  bool ok = false;
  std::string message;
};

/// What scheduling the servo thread got, and why not more.
struct SchedulingReport
{
  bool realtime = false; ///< SCHED_FIFO was granted
  int priority = 0;      ///< 1..99 with SCHED_FIFO, else 0
  std::string message;   ///< what was granted; if not real time, cause and cure
};

/// Steps of the acquisition, for the calling thread. Never abort; safe to repeat.
[[nodiscard]] Granted requestFifo(int wantedPriority);
[[nodiscard]] Granted requestTimerSlack();
[[nodiscard]] Granted requestShortSlice();
/// Lowers RLIMIT_RTTIME so that a real-time thread that runs 0.2 s without sleeping becomes an ordinary one (SIGXCPU)
/// before it can freeze the machine. Refused where the program handles SIGXCPU itself. Process-wide.
[[nodiscard]] Granted demoteRunaways();

/// Tries real-time scheduling for the calling thread within the limits granted to the user, else ordinary
/// scheduling with 1 ns timer slack and a 0.1 ms slice; pre-faults the stack. Real-time scheduling is asked for only
/// once a runaway would be demoted.
[[nodiscard]] SchedulingReport acquireScheduling(int wantedPriority = 20);

/// A thread that first acquires its scheduling, then runs the body. Joined by the destructor.
class RealtimeThread
{
public:
  RealtimeThread() = default;
  /// `onScheduled` is called on the new thread before the body. Not real-time safe.
  RealtimeThread(std::function<void(const SchedulingReport&)> onScheduled, std::function<void(std::stop_token)> body);

  void requestStop() noexcept { this->thread_.request_stop(); }
  void join();
  [[nodiscard]] bool joinable() const noexcept { return this->thread_.joinable(); }

private:
  std::jthread thread_;
};

} // namespace palpate
