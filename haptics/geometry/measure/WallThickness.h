// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "haptics/core/Types.h"
#include "haptics/geometry/tree/SurfaceTree.h"

namespace palpate
{

/// How far it is from a point of a surface straight into it to the same surface again [u]; nothing if it is not met.
/// `inward_W`: unit, away from the side that is touched. A hit nearer than rounding, 1e-12 of the largest coordinate,
/// is the place itself. Any thread.
[[nodiscard]] std::optional<double> wallThickness_u(const SurfaceTree& surface, const Vec3& p_W, const Vec3& inward_W);

} // namespace palpate
