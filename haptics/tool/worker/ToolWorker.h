// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <thread>

#include "haptics/realtime/PeriodicTimer.h"
#include "haptics/tool/worker/ToolFollower.h"

namespace palpate
{

/// The thread that moves the tool, beside the servo: it takes the newest hand a period, or as soon as the last update
/// is done. It waits for nobody and nobody waits for it.
class ToolWorker
{
public:
  /// The links must outlive it. `period_ns`: of the timer; updates that take longer skip periods.
  ToolWorker(ToolMove move, ToolLinks& links, std::int64_t period_ns, std::uint64_t work = ToolFollower::usualWork);

private:
  ToolFollower follower_;
  std::jthread thread_; ///< last: it ends before what it uses
};

} // namespace palpate
