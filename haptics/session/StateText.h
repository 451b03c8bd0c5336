// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "haptics/tick/HapticState.h"

namespace palpate
{

/// What a person sees of a session at one glance.
struct SessionGlance
{
  bool touching = false;
  EngageState engage = EngageState::Safe;
  bool preparing = false;     ///< what is shown is being read and built
  std::string refusal;        ///< why nothing of what is shown can be touched, and what to do; "" if something can
  std::string refused;        ///< the first surface that was refused and why, where nothing of the scene is left
  std::string fault;          ///< why there is no force, and what to do
  std::string warning;        ///< what needs attention
  std::string problem;        ///< the last thing that was refused
  std::string damaged;        ///< the first surface that is felt without a part of it, and why
  double limitedFrom_m = 0.0; ///< where the mouse presses deeper than the largest force allows: that depth; otherwise 0
  double limitedTo_N = 0.0;   ///< the largest force that is given, while the contact asks for more; otherwise 0
};

/// One line: how it is, why, and what to do. What nothing can be felt without comes first.
[[nodiscard]] std::string stateText(const SessionGlance& glance);

} // namespace palpate
