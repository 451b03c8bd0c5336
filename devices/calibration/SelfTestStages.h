// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/calibration/SelfTest.h"

namespace palpate
{

// How the parts of a self-test go from stage to stage. Real-time safe.

constexpr double restless_s = 8.0; ///< a person who is to hold still is given so long

inline void end(SelfTestState& state, SelfTestVerdict verdict, SelfTestReason reason) noexcept
{
  state.stage = SelfTestStage::Done;
  state.verdict = verdict;
  state.reason = reason;
}

inline void enter(SelfTestState& state, SelfTestStage stage) noexcept
{
  state.stage = stage;
  state.stage_s = state.still_s = 0.0;
  state.from_D = state.least_D = state.most_D = state.last_D;
}

} // namespace palpate
