// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "haptics/core/Types.h"
#include "haptics/tick/base/StageList.h"

namespace palpate::stage
{

/// While the clutch is held the hand stays where it was in the scene, wherever its device goes; Engage lets no force
/// through meanwhile.
struct Clutch
{
  static constexpr std::string_view name = "clutch";

  struct Plan
  {
    bool clutch = false;
    /// Another map is a motion of the hand, and blended. False: the hand begins anew, as recordings have it that do not
    /// say; a session says true (DeviceAdaptation.h).
    bool keepsHand = false;
  };
  template<class Visit, class... P>
  static void planFields(const Visit& visit, P&... p)
  {
    visit("held", p.clutch...);
    visit("keepsHand", p.keepsHand...);
  }

  struct State
  {
    Pose hand_W;        ///< in the scene [u], in the last tick that knew it
    bool known = false; ///< there was one
  };
  template<class Visit, class... S>
  static void stateFields(const Visit& visit, S&... s)
  {
    visit("hand_W", s.hand_W...);
    visit("known", s.known...);
  }

  static void step(TickContext& tick) noexcept;
};

} // namespace palpate::stage
