// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticTetraFill_h
#define vtkHapticTetraFill_h

#include <string>

#include "haptics/compliance/build/TetraMesher.h"
#include "vtkHapticPipelineModule.h" // for the export macro
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

class vtkDataSet;
class vtkImageData;
class vtkPolyData;

/// Tetrahedra of a surface or a label image; null with a problem. `note`: a remark for a person.
struct vtkHapticTetraFillResult
{
  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  std::string Problem;
  std::string Note;
  double Rough = 0.0; ///< largest distance of its border from the filled surface [u], as set
};

/// Fills a closed surface with tetrahedra. A size of 0 is chosen.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkHapticTetraFillResult vtkHapticFillSurface(
  vtkPolyData& surface, palpate::TetraSizes sizes, const palpate::Goes& goes);

/// Fills each label but 0 of an image's active point scalars, with the cell array Label.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkHapticTetraFillResult vtkHapticFillLabels(
  vtkImageData& image, palpate::TetraSizes sizes, const palpate::Goes& goes);

#endif
