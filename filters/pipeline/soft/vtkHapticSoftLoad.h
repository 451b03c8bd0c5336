// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticSoftLoad_h
#define vtkHapticSoftLoad_h

#include <string>

#include "haptics/core/Types.h"
#include "vtkHapticPipelineModule.h" // for the export macro

class vtkUnstructuredGrid;

/// Point array of permanent loads [N].
inline constexpr const char* vtkHapticLoadName = "Load";

/// Gives a described body the array Load: its weight by that gravity [m/s^2], and a point array with three numbers each
/// [N] if one is named. None where that is nothing. False with a problem.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT bool vtkHapticLoadBody(
  vtkUnstructuredGrid& body, const palpate::Vec3& gravity, const std::string& loadArray, std::string& problem);

#endif
