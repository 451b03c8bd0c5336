// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "haptics/tick/base/HapticState.h"

namespace palpate
{

/// Status of a session, for one line of text.
struct SessionGlance
{
  bool touching = false;
  EngageState engage = EngageState::Safe;
  bool preparing = false;     ///< the shown data are being read and built
  std::string refusal;        ///< why nothing of the shown data can be touched, and the remedy; "" if something can
  std::string refused;        ///< the first surface that was refused and why, where nothing of the scene is left
  std::string fault;          ///< why there is no force, and the remedy
  std::string warning;        ///< a condition that needs attention
  std::string problem;        ///< the last thing that was refused
  std::string damaged;        ///< the first surface that is felt without a part of it, and why
  double limitedFrom_m = 0.0; ///< where the mouse presses deeper than the largest force allows: that depth; otherwise 0
  double limitedTo_N = 0.0;   ///< the largest force that is given, while the contact asks for more; otherwise 0
};

/// One line: status, reason and remedy. The first condition without which nothing can be felt wins.
[[nodiscard]] std::string stateText(const SessionGlance& glance);

} // namespace palpate
