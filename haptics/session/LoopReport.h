// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "haptics/realtime/LoopStatistics.h"

namespace palpate
{

/// How the loop went so far.
struct LoopReport
{
  std::uint64_t ticks = 0;        ///< computed
  std::uint64_t missed = 0;       ///< periods that passed without a tick
  std::uint64_t periods = 0;      ///< elapsed: ticks + missed
  std::uint64_t contactTicks = 0; ///< with at least one contact
  std::uint64_t cappedTicks = 0;  ///< the god-object was stopped by its cap or budget
  std::uint64_t pinnedTicks = 0;  ///< surfaces that moved left the god-object no space
  double elapsed_s = 0.0;         ///< from the first period to the last
  double peakForce_N = 0.0;
  double peakStabiliser_N = 0.0; ///< largest part of a force that passivity control added
  double forceResidual_N = 0.0;  ///< largest |F - beside - stabiliser - K (proxy - device)| while engaged and unlimited
  Quantiles lateness;            ///< of the last 5 s [us]
  Quantiles cost;                ///< of all ticks [us]
  bool ended = false;            ///< the device has no more samples
};

} // namespace palpate
