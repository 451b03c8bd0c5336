// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <deque>
#include <memory>
#include <mutex>
#include <vector>

#include "haptics/realtime/SnapshotMailbox.h"

namespace palpate
{

/// A mailbox from a worker to the servo that also keeps the published snapshots, for the owner of the session to have
/// them recorded. The servo's side is that of the mailbox: it never takes the lock.
template<class T>
class RecordedMailbox
{
  using Snapshot = std::shared_ptr<const T>;

public:
  /// Kept for the recorder before the servo can have it: a snapshot that a tick uses must already be recordable. The
  /// publishing thread.
  void publish(Snapshot snapshot)
  {
    if (snapshot)
    {
      this->keep(snapshot);
    }
    this->mailbox_.publish(std::move(snapshot));
  }

  /// As of SnapshotMailbox. The servo.
  [[nodiscard]] const T* acquire() noexcept { return this->mailbox_.acquire(); }
  [[nodiscard]] const T* replaced() const noexcept { return this->mailbox_.replaced(); }

  /// The snapshots published since the call before, oldest first: all of them if `recorded`, else the last few, one of
  /// which the servo may have. `again`: those that were returned before, too. The owner.
  [[nodiscard]] std::vector<Snapshot> published(bool recorded, bool again = false)
  {
    if (!this->news_.exchange(false) && recorded == this->wasRecorded_ && !again)
    {
      return {};
    }
    this->wasRecorded_ = recorded;
    const std::lock_guard lock(this->mutex_);
    std::vector<Snapshot> all(this->kept_.begin(), this->kept_.end());
    while (this->kept_.size() > keptUnrecorded)
    {
      this->kept_.pop_front();
    }
    this->keepsAll_ = recorded;
    return all;
  }

private:
  /// While nobody records: the servo has one of the last two, and may take another while they are looked at.
  static constexpr std::size_t keptUnrecorded = 4;

  void keep(const Snapshot& snapshot)
  {
    const std::lock_guard lock(this->mutex_);
    this->kept_.push_back(snapshot);
    this->news_ = true;
    while (!this->keepsAll_ && this->kept_.size() > keptUnrecorded)
    {
      this->kept_.pop_front();
    }
  }

  SnapshotMailbox<T> mailbox_;
  std::mutex mutex_; ///< between publisher and owner; guards the next two
  std::deque<Snapshot> kept_;
  bool keepsAll_ = false;
  std::atomic<bool> news_ = false; ///< read without the lock at each call
  bool wasRecorded_ = false;       ///< of the owner alone
};

} // namespace palpate
