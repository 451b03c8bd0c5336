// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/core/Fault.h"

namespace palpate
{

/// The verdict on the loop's lateness: a share of the stiffness, or a fault.
struct LatenessVerdict
{
  double stiffnessFactor = 1.0;
  Fault fault = Fault::None;
};

/// The lateness rows of the fault table (docs/faults.md): a tick gap above 20 ms or p99 lateness above 5 ms over 5 s
/// drops the force; p99 of 1-5 ms scales the stiffness to the stable one at that rate, K ~ 1 / (T / 2 + lateness) (Gil
/// et al. 2009). Simulated devices only count. Pure; real-time safe.
[[nodiscard]] constexpr LatenessVerdict judgeLateness(
  double gap_s, double p99_s, double period_s, bool simulated) noexcept
{
  constexpr double largestGap_s = 0.020, dropAbove_s = 0.005, scaleAbove_s = 0.001;
  if (simulated)
  {
    return {};
  }
  if (gap_s > largestGap_s || p99_s > dropAbove_s)
  {
    return { 0.0, Fault::LateServo };
  }
  return { p99_s > scaleAbove_s ? (0.5 * period_s) / (0.5 * period_s + p99_s) : 1.0, Fault::None };
}

} // namespace palpate
