// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "haptics/tick/base/HapticState.h"
#include "haptics/tick/base/StageList.h"

namespace palpate::stage
{

/// Takes the person's request: force, or none.
struct Requests
{
  static constexpr std::string_view name = "requests";

  struct State
  {
    EngageState engage = EngageState::Safe;
    Fault fault = Fault::None;
    double gain = 0.0; ///< share of the force that is let through, 0..1
  };
  template<class Visit, class... S>
  static void stateFields(const Visit& visit, S&... s)
  {
    visit("engage", s.engage...);
    visit("fault", s.fault...);
    visit("gain", s.gain...);
  }

  static void step(TickContext& tick) noexcept;
};

/// Lets force through once it would start small: up over the engage ramp; down over the release ramp, or the shorter
/// one of a fault, and while the clutch is held.
struct Engage
{
  static constexpr std::string_view name = "engage";

  static void step(TickContext& tick) noexcept;
};

} // namespace palpate::stage
