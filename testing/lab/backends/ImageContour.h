// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "haptics/core/Types.h"

namespace palpate::lab
{

/// The product's curves of an image of size * size pixels, one unit apart, where a field passes zero; simplified within
/// a tolerance [u].
using ImageContour = std::vector<std::vector<Vec3>> (*)(
  int size, const std::function<double(double x, double y)>& field, double tolerance_u);

/// Null where this was built without VTK.
[[nodiscard]] ImageContour imageContour();

} // namespace palpate::lab
