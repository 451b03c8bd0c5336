// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>

namespace palpate
{

/// How the work on a choice goes, for a person to read.
struct WorkStatus
{
  std::string problem;       ///< why the choice cannot be felt, or does not follow the hand any more; "": it can
  bool building = false;     ///< it is meant to be felt and is not there yet
  std::uint64_t snapshots = 0; ///< that were published of it
};

/// The owner of a worker and its thread share the newest order, and the status of the work, a WorkStatus. An Order has
///   isActive()       whether there is anything to compute
///   cancels(before)  whether the work that `before` began is of no use to it
///   awaits(before)   whether it is meant to be felt and is not there yet, where `before` is
template<class Order, class Status>
class WorkerChannel
{
public:
  // Of the owner.

  [[nodiscard]] const Order& wanted() const noexcept { return this->wanted_; }
  /// Replaces the order. Without anything to compute, before and now, the thread is not told.
  void order(Order next)
  {
    {
      const std::lock_guard lock(this->mutex_);
      const bool told = next.isActive() || this->wanted_.isActive();
      if (next.cancels(this->wanted_))
      {
        this->working_.request_stop();
        this->working_ = std::stop_source();
      }
      this->status_.building = this->status_.building || next.awaits(this->wanted_);
      this->wanted_ = std::move(next);
      this->news_ = this->news_ || told;
    }
    this->changed_.notify_one();
  }
  [[nodiscard]] Status status() const
  {
    const std::lock_guard lock(this->mutex_);
    return this->status_;
  }
  void cancel() { this->working_.request_stop(); }

  // Of the thread.

  /// Read without the lock in each iteration.
  [[nodiscard]] bool hasNews() const noexcept { return this->news_; }
  /// The newest order, and the token that stops the work for it; nothing if it was read before.
  [[nodiscard]] std::optional<std::pair<Order, std::stop_token>> next()
  {
    if (!this->news_.exchange(false))
    {
      return std::nullopt;
    }
    const std::lock_guard lock(this->mutex_);
    return std::pair(this->wanted_, this->working_.get_token());
  }
  /// `change(status, wanted)` with the newest order.
  template<class Change>
  void report(const Change& change)
  {
    const std::lock_guard lock(this->mutex_);
    change(this->status_, std::as_const(this->wanted_));
  }
  /// Sleeps until that time, or without one until there is an order; until a stop in any case.
  void sleep(const std::stop_token& stop, const std::optional<std::chrono::steady_clock::time_point>& until)
  {
    std::unique_lock lock(this->mutex_);
    if (until)
    {
      this->changed_.wait_until(lock, stop, *until, [] { return false; });
    }
    else
    {
      this->changed_.wait(lock, stop, [this] { return this->hasNews(); });
    }
  }

private:
  mutable std::mutex mutex_; ///< guards all the rest
  std::condition_variable_any changed_;
  Order wanted_;
  std::stop_source working_; ///< of the work for that order
  Status status_;
  std::atomic<bool> news_ = false; ///< the order has not been read
};

} // namespace palpate
