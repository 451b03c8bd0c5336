// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/tool/motion/TargetMotion.h"
#include "haptics/tool/servo/ToolContacts.h"

namespace palpate
{

struct SettledTarget
{
  Vec6 wish = Vec6::Zero(); ///< whitened
  int rounds = 0;           ///< that it took
};

/// The law of frictionTarget(), for a tool that really moves: a residual would creep from update to update.
/// Solved in turn: the normal multipliers for given friction, exactly, and the friction for given normal multipliers,
/// by projection onto the discs. A tool comes to rest where friction just holds it, and there this settles where a
/// sweep over contacts goes on for thousands. Which of more contacts than there are directions push may change from
/// round to round: of random sets of two to five one in a hundred misses the power of Coulomb's law by 3e-5 of the
/// wish's square at a friction of 0.3, by 3e-3 at 1, by a sixth at 3. Takes tens of times as long as a tick may.
[[nodiscard]] SettledTarget settledTarget(const ToolContacts& set, const Vec6& wish, double friction) noexcept;

} // namespace palpate
