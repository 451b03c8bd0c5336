// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>

#include "devices/common/LinkedDevice.h"
#include "devices/io/ReportRate.h"

namespace palpate
{

/// What the threads of a link count, for people to see.
struct LinkCounts
{
  /// A line of its own: the reader counts every report.
  alignas(64) ReportRate rate;
  std::atomic<std::uint64_t> inputs = 0, strange = 0, outOfRange = 0; ///< reader's
  std::atomic<std::uint64_t> outputs = 0, restarts = 0;               ///< writer's

  void reportTo(LinkReport& report) const
  {
    report.inputs = this->inputs;
    report.strange = this->strange;
    report.outOfRange = this->outOfRange;
    report.outputs = this->outputs;
    report.restarts = this->restarts;
    report.inputRate_Hz = this->rate.rate_Hz();
  }
};

} // namespace palpate
