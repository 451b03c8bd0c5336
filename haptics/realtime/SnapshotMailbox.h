// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <utility>

namespace palpate
{

/// Hands immutable snapshots (scenes) to the servo. The publisher alone owns and frees them; the reader sees a raw
/// pointer that stays valid until its next acquire(), and in the tick that takes a new one also the one before.
/// Wait-free on both sides: a snapshot that the reader puts down goes into a bay of three slots that the publisher
/// empties before each publish. From the start of one emptying to the end of the next the reader can take two
/// snapshots, the one that was pending and the one published in between; with the one it already had to put down that
/// makes three.
template<class T>
class SnapshotMailbox
{
  static_assert(std::atomic<void*>::is_always_lock_free);
  using Holder = std::shared_ptr<const T>;

public:
  SnapshotMailbox() = default;
  SnapshotMailbox(const SnapshotMailbox&) = delete;
  SnapshotMailbox& operator=(const SnapshotMailbox&) = delete;
  /// Reader and publisher must have stopped.
  ~SnapshotMailbox()
  {
    this->collect();
    delete this->pending_.load();
    delete this->previous_;
    delete this->held_;
  }

  /// Publisher thread only; wait-free but for the freeing of snapshots that the reader has put down. Null is a snapshot
  /// too.
  void publish(Holder snapshot)
  {
    this->collect();
    delete this->pending_.exchange(new Holder(std::move(snapshot)), std::memory_order_acq_rel);
  }

  /// Frees the snapshots that the reader has put down. Publisher thread only.
  void collect() noexcept
  {
    for (auto& slot : this->bay_)
    {
      delete slot.exchange(nullptr, std::memory_order_acq_rel);
    }
  }

  /// Reader thread only; wait-free, frees nothing. The newest snapshot, or null before the first.
  [[nodiscard]] const T* acquire() noexcept
  {
    this->putDown(this->previous_);
    this->previous_ = nullptr;
    if (Holder* const news = this->pending_.exchange(nullptr, std::memory_order_acq_rel))
    {
      this->previous_ = this->held_;
      this->held_ = news;
    }
    return this->held_ != nullptr ? this->held_->get() : nullptr;
  }

  /// The snapshot that the last acquire() replaced, or null if it brought nothing new. Reader thread only; wait-free.
  [[nodiscard]] const T* replaced() const noexcept
  {
    return this->previous_ != nullptr ? this->previous_->get() : nullptr;
  }

private:
  void putDown(Holder* old) noexcept
  {
    for (auto& slot : this->bay_)
    {
      Holder* empty = nullptr;
      if (old == nullptr || slot.compare_exchange_strong(empty, old, std::memory_order_acq_rel))
      {
        return;
      }
    }
  }

  alignas(64) std::atomic<Holder*> pending_ = nullptr;
  alignas(64) std::array<std::atomic<Holder*>, 3> bay_{};
  alignas(64) Holder* held_ = nullptr; ///< reader's
  Holder* previous_ = nullptr;         ///< reader's, for one tick
};

} // namespace palpate
