// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticCliScene_h
#define vtkHapticCliScene_h

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "haptics/session/path/PathInputs.h"
#include "haptics/session/scene/TouchedData.h"
#include "vtkHapticMaterialArrays.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

/// Faces of a file and, where they are wanted, its curves; images of which an iso surface is made with `iso`. A
/// reader's notes go to stderr. Throws vtkHapticCliProblem. An array that cannot be used is a problem of the result:
/// the caller knows whether it must be there.
[[nodiscard]] std::vector<palpate::PathSurface> vtkHapticCliReadSurface(const std::string& file,
  std::optional<double> iso, const vtkHapticMaterialSettings& materials = {}, bool curves = false);

/// The same as data, for the filter.
[[nodiscard]] vtkSmartPointer<vtkPolyData> vtkHapticCliReadData(const std::string& file, std::optional<double> iso);

/// Throws vtkHapticCliProblem where there is an iso value and no image among the files.
void vtkHapticCliCheckIsoIsUsed(const std::vector<std::string>& files, std::optional<double> iso);

/// Throws vtkHapticCliProblem that names an untouchable surface.
void vtkHapticCliCheckWhole(const palpate::WholeScene& whole);

/// The scene of surfaces as they were read. Throws vtkHapticCliProblem that names an untouchable surface; notes of
/// cleaning go to stderr.
[[nodiscard]] std::shared_ptr<const palpate::Scene> vtkHapticCliBuild(const std::vector<palpate::SurfaceInput>& inputs);

#endif
