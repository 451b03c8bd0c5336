// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/tool/motion/TargetMotion.h"
#include "haptics/tool/servo/ToolContacts.h"

namespace palpate
{

/// The largest friction coefficient of a tool. Above it contacts that wedge have several solutions, and no solver finds
/// the same one from tick to tick.
inline constexpr double largestToolFriction = 1.0;

/// The target motion that moves a tool without friction as `wish` moves it with friction: the friction of a contact
/// with normal force p is at most `friction` p and opposes the motion of its point, or the point sticks (Coulomb, one
/// coefficient at rest and in motion).
///
/// For the tick: a dozen sweeps of projected Gauss-Seidel (Jourdan, Alart & Jean 1998): each contact in turn pushes
/// until its gap is kept, then its friction acts towards rest within the disc of that push. The forces begin at zero,
/// so that the result depends continuously on the wish even where the pushes of many contacts are not unique. Where
/// friction just stops the tool the error is some hundredths of the friction, elsewhere a thousandth. Real-time safe.
[[nodiscard]] Vec6 frictionTarget(const ToolContacts& set, const Vec6& wish, double friction) noexcept;

} // namespace palpate
