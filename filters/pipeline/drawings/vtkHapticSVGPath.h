// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticSVGPath_h
#define vtkHapticSVGPath_h

#include <Eigen/Geometry>
#include <string_view>
#include <vector>

#include "vtkHapticPlaneLines.h"

/// The small languages inside the attributes of SVG 1.1 (W3C 2011). All are untrusted text: every function throws
/// std::runtime_error with the expected text and the number of read characters.
namespace vtkHapticSVGPath
{
/// Path data (section 8.3): all commands, absolute and relative. A broken path is refused as a whole; the standard lets
/// it be drawn up to the error, but half a wall is a hole.
void Append(std::string_view data, vtkHapticPlaneLines& lines);

/// The list of numbers of `points`, in pairs.
[[nodiscard]] std::vector<vtkHapticPlaneLines::Point> ParsePoints(std::string_view text);

/// Numbers with commas and blanks between them, as in `viewBox`.
[[nodiscard]] std::vector<double> ParseNumbers(std::string_view text);

/// `transform` (section 7.6): matrix, translate, scale, rotate, skewX, skewY, one after the other.
[[nodiscard]] Eigen::Affine2d ParseTransform(std::string_view text);
} // namespace vtkHapticSVGPath

#endif
