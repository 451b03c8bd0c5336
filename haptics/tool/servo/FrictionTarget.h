// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/tool/motion/TargetMotion.h"
#include "haptics/tool/servo/ToolContacts.h"

namespace palpate
{

/// Beyond it contacts that wedge leave more than one answer, which neither law finds from tick to tick: nothing rubs
/// more.
inline constexpr double largestToolFriction = 1.0;

/// The wish for which the tool goes without friction where it goes for `wish` with friction: each contact that pushes
/// by p rubs by at most `friction` p, against the motion of its point, or holds the point where it is (Coulomb, one
/// coefficient at rest and in motion).
///
/// For the tick: a dozen sweeps of projected Gauss-Seidel (Jourdan, Alart & Jean 1998), each contact in turn pushes
/// until it holds its gap, then rubs towards rest within the disc of that push. From no force on, so that the result
/// depends continuously on the wish even where the pushes of many contacts are not unique. Where friction just holds
/// the tool it is good to some hundredths of what rubs, elsewhere to a thousandth. Real-time safe.
[[nodiscard]] Vec6 frictionTarget(const ToolContacts& set, const Vec6& wish, double friction) noexcept;

} // namespace palpate
