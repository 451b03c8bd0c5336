// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/field/FieldBlock.h"

namespace palpate
{

/// A value with its first and second derivatives in W.
struct SmoothSample
{
  double value = 0.0;
  Vec3 gradient_W = Vec3::Zero(); ///< [1/u]
  Mat3 bend_W = Mat3::Zero();     ///< [1/u^2]
};

/// The scalar of a block with a gradient that has no steps: a quadratic B-spline whose coefficients are the values.
/// Functions that are linear it has exactly; of others its difference is h^2 / 8 times the Laplacian, where trilinear
/// values are up to that off too. A potential of trilinear values has creases at the faces of cells, over which a hand
/// is let go and loses. None outside, where one of the 27 values around has none, and in a block of fewer than three
/// points along an axis.
[[nodiscard]] std::optional<SmoothSample> smoothScalar(const FieldBlock& brick, const Vec3& p_W) noexcept;

} // namespace palpate
