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

/// Computes the shape of a soft body (no more often than a view draws it) and the inverse from which snapshots are
/// answered, in a thread of its own with low priority, so that snapshots do not wait. Objects that it receives must
/// outlive it.
class SoftAside
{
public:
  using Publish = std::function<void(BodyShape)>;

  /// `publish`: called in that thread.
  explicit SoftAside(Publish publish);

  /// Orders the shape of `sight` in place of an older order.
  void look(BodySight sight);
  /// Orders the condensation of `kept` in place of an older order; null: changes nothing.
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
  std::jthread thread_; ///< last: joined before the other members are destroyed
};

} // namespace palpate
