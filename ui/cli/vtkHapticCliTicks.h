// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticCliTicks_h
#define vtkHapticCliTicks_h

#include <cstdint>
#include <string>
#include <vector>

#include "haptics/core/Clock.h"
#include "haptics/tick/HapticState.h"
#include "vtkHapticCliOutput.h"

/// Time around a tick, less what asking the clock twice takes by itself (the median of many empty measurements).
class vtkHapticCliStopwatch
{
public:
  vtkHapticCliStopwatch();
  void Start() { this->Start_ns = this->Clock.now_ns(); }
  /// Since Start() [us], never negative.
  [[nodiscard]] double Cost_us() const;

private:
  palpate::MonotonicClock Clock;
  std::int64_t Start_ns = 0;
  double Overhead_us = 0.0;
};

/// The header of a CSV of ticks; `more`: columns after those of every tick.
void vtkHapticCliWriteHeader(vtkHapticCliOutput& output, const std::string& more = "");

/// One row: time [s], device, proxy [scene units], force on the hand as seen in the scene [N], contacts, cost [us] and
/// the values of the columns after those.
void vtkHapticCliWriteTick(vtkHapticCliOutput& output, double time_s, const palpate::HapticState& state, double cost_us,
  const std::vector<double>& more = {});

/// What became of a law, as a person reads it.
[[nodiscard]] const char* vtkHapticCliSaid(palpate::LawChange change);

#endif
