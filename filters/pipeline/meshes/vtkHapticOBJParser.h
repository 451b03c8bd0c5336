// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticOBJParser_h
#define vtkHapticOBJParser_h

#include "vtkHapticFaceMesh.h"

#include <string_view>

/// Reads points (`v`) and faces (`f`) of a Wavefront OBJ text; names, materials, normals, texture coordinates, lines
/// and single points are skipped, free-form curves and surfaces refused. Negative indices count from the end.
/// VTK's own reader is not used because it reads outside of its arrays when an index is out of range.
[[nodiscard]] vtkHapticFaceMesh vtkHapticParseOBJ(std::string_view text);

#endif
