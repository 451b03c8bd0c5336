// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "haptics/contact/view/FaceList.h"
#include "haptics/contact/view/GodObjectState.h"
#include "haptics/contact/view/SceneView.h"
#include "haptics/contact/view/SweptBall.h"
#include "haptics/core/Types.h"

namespace palpate
{

/// Opens the faces that are kept around the ball for a scene as it is now. Those of other content are dropped, and of
/// another moment those that hold for one moment only.
template<SceneView AnyScene>
void openKept(const AnyScene& scene, FacesAround& around) noexcept;

/// The list that is kept of the faces around a motion, or null; `work` grows by the cost of picking them.
template<SceneView AnyScene>
[[nodiscard]] const FaceList* keptFor(
  const AnyScene& scene, const SweptBall& m, FacesAround& around, std::uint32_t& work) noexcept;

/// Picks the faces around a ball while surfaces bend, as they are now, for the questions of a tick that are near
/// enough. Nothing is done where no faces of the scene are kept to pick from.
template<SceneView AnyScene>
void pickAround(const AnyScene& scene, const Vec3& x_W, double radius_u, FacesAround& around) noexcept;

/// The list that is kept of the faces around a motion in this scene as it is now, or null; it is left as it is.
template<SceneView AnyScene>
[[nodiscard]] const FaceList* listAround(const AnyScene& scene, const SweptBall& m, const FacesAround& around) noexcept;

/// Gathers the faces around a ball that went on from a place in this tick, for the ticks that follow, unless they are
/// there. Of surfaces that bend, all the rest of their way counts; nothing is gathered where one moves as a whole.
/// Bounded on its own account: the work of a tick is not charged. Not for a tick that opened them, which is dear
/// enough, nor for a second time in a tick.
template<SceneView AnyScene>
void renewKept(const AnyScene& scene, double radius_u, const Vec3& from_W, GodObjectState& state) noexcept;

} // namespace palpate
