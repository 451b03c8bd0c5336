// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticImageLines_h
#define vtkHapticImageLines_h

#include "haptics/geometry/ink/InkLines.h"

class vtkHapticImagePlane;

/// Loose lines of a flat image, in pixel coordinates (i, j, 0); none at pixels that are not finite. Each throws
/// std::runtime_error with a reason. `goes` is told the share done and answers whether to go on; if not, the lines so
/// far are returned.
namespace vtkHapticImageLines
{
/// Where the values pass `value`.
[[nodiscard]] palpate::LooseLines Contour(const vtkHapticImagePlane& plane, double value, const palpate::Goes& goes);

/// Borders of areas with the same whole value.
[[nodiscard]] palpate::LooseLines Labels(const vtkHapticImagePlane& plane, const palpate::Goes& goes);

/// The share of an image that is ink, and its middle lines.
struct Drawn
{
  double InkShare = 0.0;
  palpate::LooseLines Lines;
};

/// Of strokes darker, or lighter, than `value`; gaps up to `gap` [u] closed.
[[nodiscard]] Drawn Drawing(
  const vtkHapticImagePlane& plane, double value, bool inkIsDark, double gap, const palpate::Goes& goes);
} // namespace vtkHapticImageLines

#endif
