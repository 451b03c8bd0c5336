// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticPLYParser_h
#define vtkHapticPLYParser_h

#include "vtkHapticFaceMesh.h"

#include <string_view>

/// Reads the content of a PLY file (Turk 1994), text or binary of either byte order: `x`, `y`, `z` of the element
/// `vertex` and the list `vertex_indices` (or `vertex_index`) of the elements `face` and `tristrips`, where -1 stands
/// between two strips; everything else is read over, lines of the header that begin with no word of PLY too.
/// Refused: list lengths that are no whole numbers, and a file that holds more or less than its header promises.
/// Memory is bounded by the length of the content, never by its header.
/// VTK's own reader is not used because a file that is cut short makes it crash.
[[nodiscard]] vtkHapticFaceMesh vtkHapticParsePLY(std::string_view content);

#endif
