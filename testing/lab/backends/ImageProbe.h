// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "haptics/field/cells/GridPlace.h"

namespace palpate::lab
{

/// VTK's linear interpolation at a place, in index coordinates.
using ImageProbe = std::function<double(const Vec3& index)>;
/// Of values at the points of a grid, x fastest, which must outlive it.
using ImageProbeMaker = ImageProbe (*)(const GridIndex& size, const std::vector<float>& values);

/// Null where this was built without VTK.
[[nodiscard]] ImageProbeMaker imageProbe();

} // namespace palpate::lab
