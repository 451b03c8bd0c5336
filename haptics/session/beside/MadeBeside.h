// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <deque>
#include <memory>
#include <mutex>
#include <vector>

namespace palpate
{

/// What a thread beside the servo has made, for the owner of the session to have it recorded.
template<class T>
class MadeBeside
{
public:
  /// Before the servo can have it. The making thread.
  void put(std::shared_ptr<const T> one)
  {
    const std::lock_guard lock(this->mutex_);
    this->made_.push_back(std::move(one));
    this->told_ = true;
    while (!this->keepsAll_ && this->made_.size() > keptUnasked)
    {
      this->made_.pop_front();
    }
  }

  /// What was made since the call before, oldest first: all of it if `recorded`, else the last few, one of which the
  /// servo may have. `again`: those that were told before, too. The owner.
  [[nodiscard]] std::vector<std::shared_ptr<const T>> take(bool recorded, bool again = false)
  {
    if (!this->told_.exchange(false) && recorded == this->askedAll_ && !again)
    {
      return {};
    }
    this->askedAll_ = recorded;
    const std::lock_guard lock(this->mutex_);
    std::vector<std::shared_ptr<const T>> all(this->made_.begin(), this->made_.end());
    while (this->made_.size() > keptUnasked)
    {
      this->made_.pop_front();
    }
    this->keepsAll_ = recorded;
    return all;
  }

private:
  /// Of what nobody records: the servo has one of the last two, and may take another while they are looked at.
  static constexpr std::size_t keptUnasked = 4;

  std::mutex mutex_; ///< guards the next two
  std::deque<std::shared_ptr<const T>> made_;
  bool keepsAll_ = false;
  std::atomic<bool> told_ = false; ///< asked without the lock at each look
  bool askedAll_ = false;          ///< of the owner alone
};

} // namespace palpate
