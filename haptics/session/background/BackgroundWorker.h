// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <chrono>
#include <new>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

#include "haptics/session/background/WorkerChannel.h"

namespace palpate
{

/// Of a rate that a person sets [s]; at least one iteration in two seconds.
[[nodiscard]] inline double workerPeriod_s(double rate_Hz) noexcept
{
  constexpr double slowest_Hz = 0.5;
  return 1.0 / std::max(rate_Hz, slowest_Hz);
}

/// A thread beside the servo that computes one kind of input of the tick. Its owner never waits for it, but for its
/// end, and then no longer than an iteration takes. A session that never orders anything has no thread for it. A Task
/// is used by the thread alone:
///   Order, Status                see WorkerChannel; two orders compare equal where the work is the same
///   Task(channel, links)
///   apply(order, stop, again)    a newer order, `again` if the one before was interrupted; true: this one was, too
///   iterate()                    computes once; the period until it begins again [s], none: nothing is to be computed
///   step(time_s)                 likewise after a tick at that time, in virtual time
///   giveUp()                     frees memory and reports why: there was not enough
/// and, where it has use for it,
///   publishFirst()               of the owner, before there is a thread
template<class Task>
class BackgroundWorker
{
public:
  using Order = typename Task::Order;
  using Status = typename Task::Status;

  /// In virtual time there is no thread: see step(). The links must outlive it.
  template<class Links>
  BackgroundWorker(Links& links, bool virtualTime) : virtualTime_(virtualTime), task_(this->channel_, links)
  {
  }
  ~BackgroundWorker() { this->channel_.cancel(); }

  [[nodiscard]] Status status() const { return this->channel_.status(); }
  /// The thread begins with the first order that has anything to compute.
  void order(Order next)
  {
    if (next == this->channel_.wanted())
    {
      return;
    }
    const bool begins = next.isActive() && !this->virtualTime_ && !this->thread_.joinable();
    if constexpr (requires(Task& task) { task.publishFirst(); })
    {
      begins ? this->task_.publishFirst() : void();
    }
    this->channel_.order(std::move(next));
    if (begins)
    {
      this->thread_ = std::jthread([this](const std::stop_token& stop) { this->run(stop); });
    }
  }
  /// Computes in the caller's thread, after a tick at that time. Virtual time.
  void step(double time_s)
  {
    this->work([this, time_s] { this->task_.step(time_s); });
  }

private:
  using Clock = std::chrono::steady_clock;

  /// A factor may need more memory than there is, which is no reason to end the program.
  template<class Compute>
  void work(const Compute& compute)
  {
    try
    {
      if (auto next = this->channel_.next())
      {
        this->interrupted_ = this->task_.apply(std::move(next->first), next->second, this->interrupted_);
      }
      compute();
    }
    catch (const std::bad_alloc&)
    {
      this->task_.giveUp();
    }
  }

  void run(const std::stop_token& stop)
  {
    for (auto due = Clock::now(); !stop.stop_requested();)
    {
      std::optional<double> period_s;
      this->work([this, &period_s] { period_s = this->task_.iterate(); });
      const auto next = period_s ? std::optional(nextAfter(due, *period_s)) : std::nullopt;
      this->channel_.sleep(stop, next);
      due = next.value_or(Clock::now());
    }
  }

  /// The beginning of the period after one that began then: of the last that has begun already, after an iteration that
  /// took longer.
  [[nodiscard]] static Clock::time_point nextAfter(Clock::time_point due, double period_s)
  {
    const auto period = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(period_s));
    return due + period * std::max<Clock::rep>((Clock::now() - due) / period, 1);
  }

  bool virtualTime_;
  WorkerChannel<Order, Status> channel_;
  bool interrupted_ = false; ///< of the thread alone, like the task
  Task task_;
  std::jthread thread_; ///< last: the thread ends before the members that it uses
};

} // namespace palpate
