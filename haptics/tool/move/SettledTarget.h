// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/tool/motion/TargetMotion.h"
#include "haptics/tool/servo/ToolContacts.h"

namespace palpate
{

struct SettledTarget
{
  Vec6 wish = Vec6::Zero(); ///< whitened
  int rounds = 0;           ///< until convergence
};

/// The friction law of frictionTarget(), for a tool that really moves: there a residual would creep with each update.
/// Solved in turn: the normal multipliers for given friction, exactly, and the friction for given normal multipliers,
/// by projection onto the discs. A tool comes to rest where friction just holds it, and there this converges, while a
/// sweep over contacts takes thousands of rounds. Where more contacts touch than there are degrees of freedom, the
/// active ones may change: of random sets of two to five one in a hundred misses the power of Coulomb's law by 3e-5 of
/// the wish's square at a friction of 0.3, by 3e-3 at 1, by a sixth at 3. Takes tens of times as long as a tick may.
[[nodiscard]] SettledTarget settledTarget(const ToolContacts& set, const Vec6& wish, double friction) noexcept;

} // namespace palpate
