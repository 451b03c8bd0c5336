// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/worker/ToolWorker.h"

#include <utility>

namespace palpate
{

ToolWorker::ToolWorker(ToolMove move, ToolLinks& links, std::int64_t period_ns, std::uint64_t work)
  : follower_(std::move(move), links, work), thread_(
                                               [this, period_ns](const std::stop_token& stop)
                                               {
                                                 PeriodicTimer timer(period_ns);
                                                 while (!stop.stop_requested())
                                                 {
                                                   timer.wait();
                                                   this->follower_.step();
                                                 }
                                               })
{
}

} // namespace palpate
