// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "haptics/core/Types.h"
#include "testing/lab/Table.h"

namespace palpate::lab
{

/// A value for each pixel (x, y).
using PixelField = std::function<double(double x, double y)>;

/// The product's curves of an image of size * size pixels, one unit apart, where a field passes zero; simplified within
/// a tolerance [u].
using ImageContour = std::vector<std::vector<Vec3>> (*)(int size, const PixelField& field, double tolerance_u);

/// Null where this was built without VTK.
[[nodiscard]] ImageContour imageContour();

/// How the product takes an image.
enum class ImageKind
{
  Contour,
  Labels,
  Drawing,
};

/// The cost of the curves of an image of size * size pixels, and the product's reports of progress.
struct ImageRun
{
  Cost cost;                ///< of the whole image
  double longestStep = 0.0; ///< of the reported share of the work, 0..1
};

using ImageRunner = ImageRun (*)(ImageKind kind, int size, const PixelField& field);

/// Null where this was built without VTK.
[[nodiscard]] ImageRunner imageRunner();

} // namespace palpate::lab
