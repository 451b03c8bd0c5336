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

/// Opens the faces that are kept around the ball for a scene as it is now: those of another moment are dropped.
template<SceneView AnyScene>
void openKept(const AnyScene& scene, FacesAround& around) noexcept;

/// The list that is kept of the faces around a motion, or null; `work` grows by what it takes to pick them.
[[nodiscard]] const FaceList* keptFor(
  const SweptBall& m, double coat_u, FacesAround& around, std::uint32_t& work) noexcept;

/// Gathers the faces around a ball that went on from a place in this tick, for the ticks that follow, unless they are
/// there. Nothing is gathered where surfaces are on their way. Bounded on its own account: the work of a tick is not
/// charged.
template<SceneView AnyScene>
void renewKept(const AnyScene& scene, double radius_u, const Vec3& from_W, GodObjectState& state) noexcept;

} // namespace palpate
