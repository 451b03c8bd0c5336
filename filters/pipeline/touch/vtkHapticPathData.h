// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticPathData_h
#define vtkHapticPathData_h

#include <string>
#include <vector>

#include "haptics/session/path/PathInputs.h"
#include "vtkHapticFieldData.h"
#include "vtkHapticMaterialArrays.h"

class vtkDataObject;

/// Which arrays of surfaces and of a field settings name, and how.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkHapticMaterialSettings vtkHapticMaterialsOf(
  const palpate::SettingStore& settings);
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkHapticFieldArrays vtkHapticFieldArraysOf(
  const palpate::SettingStore& settings);

/// The faces of data and, where they are wanted, their curves, with the material from their arrays; none with a
/// problem.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT std::vector<palpate::PathSurface> vtkHapticToPathSurfaces(vtkDataObject& data,
  const std::string& name, const vtkHapticMaterialSettings& materials, bool curves, std::string& problem);

/// The faces of data as a loose body of that density [kg/m3], above 0; no other input, then with a problem.
VTKHAPTICPIPELINE_EXPORT void vtkHapticAddLoose(
  vtkDataObject& data, const std::string& name, double density, palpate::PathInputs& inputs, std::string& problem);

#endif
