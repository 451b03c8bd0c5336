// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticImageLines_h
#define vtkHapticImageLines_h

#include <functional>

#include "haptics/geometry/InkLines.h"

class vtkHapticImagePlane;

/// Loose lines of a flat image, in pixel coordinates (i, j, 0). Each throws std::runtime_error with a reason.
namespace vtkHapticImageLines
{
/// Where the values pass `value`; none at pixels that are not finite.
[[nodiscard]] palpate::LooseLines Contour(const vtkHapticImagePlane& plane, double value);

/// Borders of areas with the same whole value. `goes` is told the share done and answers whether to go on.
[[nodiscard]] palpate::LooseLines Labels(const vtkHapticImagePlane& plane, const std::function<bool(double)>& goes);

/// The middle lines of what is darker, or lighter, than `value`; gaps up to `gap` [u] closed.
[[nodiscard]] palpate::LooseLines Drawing(const vtkHapticImagePlane& plane, double value, bool inkIsDark, double gap);
} // namespace vtkHapticImageLines

#endif
