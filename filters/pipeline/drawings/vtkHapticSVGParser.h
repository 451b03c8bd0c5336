// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticSVGParser_h
#define vtkHapticSVGParser_h

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "vtkHapticPlaneLines.h"

/// Content of a drawing: lines, and for a maze the places of its start and its exit.
struct vtkHapticDrawing
{
  std::vector<vtkHapticPlaneLines::Line> Lines; ///< in user units, y upwards; empty on a problem
  std::optional<vtkHapticPlaneLines::Point> Start;
  std::optional<vtkHapticPlaneLines::Point> Exit;
  double Tolerance = 0.0; ///< chords of curves are nowhere farther from them [u]
  std::string Problem;    ///< one line: the element and its fault
  std::string Note;       ///< ignored elements, one line; mostly empty
};

/// Reads the lines of an SVG 1.1 drawing (W3C 2011): path, line, polyline, polygon, rect, circle and ellipse, with all
/// transforms. A stroke is its middle line and a filled shape its outline, whatever the width. The centre of the shape
/// with the id `start` or `exit` is that place of a maze and no line. Text, images and `use` are noted and left out,
/// and so are elements that are not displayed. Curves become chords within a ten-thousandth of the drawing's diagonal.
/// Not NanoSVG, which passes over broken paths in silence.
[[nodiscard]] vtkHapticDrawing vtkHapticParseSVG(std::string_view content);

#endif
