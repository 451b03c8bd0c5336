// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/field/Brick.h"

namespace palpate
{

/// The scalar of a brick with a gradient that has no steps: a quadratic B-spline whose coefficients are the values.
/// Functions that are linear it has exactly; of others its difference is h^2 / 8 times the Laplacian, where trilinear
/// values are up to that off too. A potential of trilinear values has creases at the faces of cells, over which a hand
/// is let go and loses. None outside, and where one of the 27 values around has none.
[[nodiscard]] std::optional<FieldSample> smoothScalar(const Brick& brick, const Vec3& p_W) noexcept;

} // namespace palpate
