// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/contact/view/ContactPlan.h"
#include "haptics/contact/view/FaceList.h"
#include "haptics/contact/view/Resolution.h"
#include "haptics/contact/view/SceneView.h"
#include "haptics/core/Types.h"
#include "haptics/geometry/scene/Scene.h"

namespace palpate
{

/// Finds a free place for the ball of a plan, of radius r >= 0, whose centre is put at p_W. A point exactly on a
/// triangle is lifted off the triangle; a ball that overlaps is moved out to the side of its centre by repeated least
/// displacement. Local, bounded, allocation-free. Returns false and leaves `x_W` alone if there is no free place within
/// r. `around`: faces that may be kept around the place, or null; they change nothing but the cost.
template<SceneView AnyScene>
[[nodiscard]] bool seatBall(const AnyScene& scene, const ContactPlan& plan, const Vec3& p_W, Vec3& x_W,
  const FacesAround* around = nullptr) noexcept;

} // namespace palpate
