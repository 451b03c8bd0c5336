// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>

#include "haptics/contact/view/FaceList.h"
#include "haptics/contact/view/Resolution.h"
#include "haptics/contact/view/SceneView.h"
#include "haptics/contact/view/SweptBall.h"
#include "haptics/core/Types.h"

namespace palpate
{

/// True if all that the motion can touch lies within reach.
[[nodiscard]] inline bool covers(const Reach& reach, const SweptBall& m) noexcept
{
  const double furthest = std::max((m.x_W - reach.centre_W).norm(), (m.e_W - reach.centre_W).norm());
  return reach.reach_u > 0.0 && furthest + m.r + 2 * m.tol <= reach.reach_u;
}

/// The reach of a motion and of the motions that follow it in a tick.
[[nodiscard]] Reach reachFor(const SweptBall& m) noexcept;

/// A ball of that reach that stands still.
[[nodiscard]] SweptBall standing(const Reach& reach, const Resolution& resolution) noexcept;

/// At which moments of a scene that bends a list holds the faces within reach.
enum class Moments
{
  Now,
  ToTheEnd, ///< from now to the end of their way. Balls go with them. No surface may move as a whole
};

/// A disc around a face.
[[nodiscard]] PlacedDisc discOf(const FaceRecord& face) noexcept;

/// Fills the list with the faces within reach. False if they are more than `most`, or the walk takes more nodes than
/// the budget: the list is then empty.
template<SceneView AnyScene>
[[nodiscard]] bool gatherFaces(const AnyScene& scene, Moments moments, const Reach& reach, const Resolution& resolution,
  int most, std::uint32_t budget, std::uint32_t& nodes, FaceList& list) noexcept;

} // namespace palpate
