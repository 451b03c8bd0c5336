// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "haptics/compliance/body/KeptInverse.h"
#include "haptics/session/soft/BodySight.h"

namespace palpate
{

/// What is computed of a soft body beside its snapshots, in a thread of its own that gives way to all others: its
/// shape, no more often than it is drawn, and the inverse from which snapshots are answered. What it is given lives
/// longer.
class SoftAside
{
public:
  using Publish = std::function<void(BodyShape)>;

  /// `publish`: called in that thread.
  explicit SoftAside(Publish publish);

  /// The newest one is looked at.
  void look(BodySight sight);
  /// In place of any other; null: nothing is ordered.
  void condense(std::shared_ptr<KeptInverse> kept);

private:
  using Clock = std::chrono::steady_clock;
  struct Work
  {
    std::optional<BodySight> sight;
    std::shared_ptr<KeptInverse> kept;
  };

  void run(const std::stop_token& stop);
  [[nodiscard]] Work next(const std::stop_token& stop, Clock::time_point nextLook);
  void lookAt(const BodySight& sight);
  void condenseNext(const std::shared_ptr<KeptInverse>& kept);

  Publish publish_;
  std::mutex mutex_; ///< guards the work
  std::condition_variable_any changed_;
  Work work_;
  std::jthread thread_; ///< last: it ends before what it uses
};

} // namespace palpate
