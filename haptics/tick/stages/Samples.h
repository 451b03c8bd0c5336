// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string_view>

#include "haptics/tick/base/StageList.h"

namespace palpate::stage
{

/// Judges the samples of the device and the loop. A tick that does not know where the hand is gives no force: the
/// stages after this one rest.
struct Samples
{
  static constexpr std::string_view name = "samples";

  struct State
  {
    static constexpr double longAgo_s = std::numeric_limits<double>::infinity();

    double sinceBad_s = longAgo_s;       ///< time since the last sample that was not finite
    double sinceBadBefore_s = longAgo_s; ///< and since the one before it
  };
  template<class Visit, class... S>
  static void stateFields(const Visit& visit, S&... s)
  {
    visit("sinceBad_s", s.sinceBad_s...);
    visit("sinceBadBefore_s", s.sinceBadBefore_s...);
  }

  /// Bad samples of before do not count any more.
  static void forget(State& state) noexcept;
  static void step(TickContext& tick) noexcept;
};

} // namespace palpate::stage
