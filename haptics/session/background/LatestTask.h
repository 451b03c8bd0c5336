// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>
#include <future>
#include <optional>
#include <stop_token>
#include <utility>

namespace palpate
{

/// Computes results off the caller's thread, one at a time, of the newest wish. One thread calls every method.
template<class Result>
class LatestTask
{
public:
  struct Work
  {
    std::function<Result()> compute;
    bool atOnce = false; ///< in the caller's thread
  };
  /// Gives the work when it begins, since the work may depend on the result before. The token says that the result is
  /// not wanted any more.
  using Wish = std::function<Work(const std::stop_token&)>;

  LatestTask() = default;
  /// Waits for the thread.
  ~LatestTask()
  {
    this->cancel();
    if (this->running())
    {
      this->running_.wait();
    }
  }
  LatestTask(const LatestTask&) = delete;
  LatestTask& operator=(const LatestTask&) = delete;

  [[nodiscard]] bool running() const noexcept { return this->running_.valid(); }
  /// Begins, or waits in place of any other wish until the running work ends. True if the work is done already.
  bool want(Wish wish)
  {
    this->next_ = std::move(wish);
    return this->resume();
  }
  /// Begins the wish that waits, unless work is running. True if the work is done already.
  bool resume()
  {
    if (!this->next_ || this->running())
    {
      return false;
    }
    this->stop_ = std::stop_source();
    const Work work = (*std::exchange(this->next_, std::nullopt))(this->stop_.get_token());
    this->running_ = std::async(work.atOnce ? std::launch::deferred : std::launch::async, work.compute);
    if (work.atOnce)
    {
      this->running_.wait();
    }
    return work.atOnce;
  }
  /// Nothing is wanted any more: the running work gives no result.
  void cancel()
  {
    this->next_.reset();
    this->stop_.request_stop();
  }

  /// The result, once, when it is there. After cancelled work the wish that waits begins. After a result it waits for
  /// resume(), so that the caller can put the result to use before.
  std::optional<Result> poll()
  {
    if (!this->running() || this->running_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
    {
      return std::nullopt;
    }
    const bool wanted = !this->stop_.stop_requested();
    std::optional<Result> result = this->running_.get();
    if (!wanted)
    {
      this->resume();
      result.reset();
    }
    return result;
  }
  /// The result of the last wish, waiting for it. Nothing if nothing is wanted.
  std::optional<Result> wait()
  {
    std::optional<Result> newest;
    while (this->running())
    {
      this->running_.wait();
      newest = this->poll();
      this->resume();
    }
    return newest;
  }

private:
  std::future<Result> running_;
  std::stop_source stop_;    ///< of the running work
  std::optional<Wish> next_; ///< waits until the running work ends
};

} // namespace palpate
