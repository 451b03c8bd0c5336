// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/contact/view/ContactPlan.h"
#include "haptics/contact/view/GodObjectState.h"
#include "haptics/contact/view/SceneView.h"

namespace palpate
{

/// The effect of moving surfaces on the ball in a tick.
struct CarryResult
{
  bool carried = false; ///< it was moved along or pushed
  bool pinned = false;  ///< surfaces close on it: less room is left than the ball needs
  std::uint32_t work = 0;
};

/// Takes the ball along with the surfaces that moved between two moments, so that none passes it.
///
/// A ball that a moving surface touches goes with that surface; a ball that a surface runs into is pushed before it.
/// The ball's path relative to each surface is straight in the frame of that surface. This path must be free,
/// for a point exactly. Surfaces that close like scissors push together: by the least motion that keeps the ball in
/// front of all of them. Where the surfaces leave no such place, the ball shrinks to its centre, which stays between
/// them, and `pinned` is set. A centre between two parallel plates that meet has no place either and stays with the
/// plate that it touched first.
/// `now` may be of another scene than `before`; the features of `state` are of `now`'s. A surface of `now` that was not
/// in `before` counts as not moving. Bounded, allocation-free.
[[nodiscard]] CarryResult carryBall(
  const MovingScene& before, const MovingScene& now, const ContactPlan& plan, GodObjectState& state) noexcept;

} // namespace palpate
