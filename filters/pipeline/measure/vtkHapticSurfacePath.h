// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticSurfacePath_h
#define vtkHapticSurfacePath_h

#include "vtkHapticPipelineModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

class vtkAlgorithmOutput;

/**
 * @class vtkHapticSurfacePath
 * @brief The shortest path over a surface from mark to mark.
 *
 * Port 0: the surface, any data with polygons; port 1: the marks in their order, the points of a point set or the rows
 * of a table with the columns X, Y and Z [u]. Each mark stands for the nearest point of the surface. Output: a polyline
 * from each mark to the next, with the cell arrays Length and Straight [u], its own length and that of the straight
 * line, and the point array Way [u] from its first mark. The path is exact on the triangles
 * (haptics/geometry/measure/SurfacePath.h). Between marks that have none nothing is drawn, and one line says which.
 */
class VTKHAPTICPIPELINE_EXPORT vtkHapticSurfacePath : public vtkPolyDataAlgorithm
{
public:
  static vtkHapticSurfacePath* New();
  vtkTypeMacro(vtkHapticSurfacePath, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void SetMarksConnection(vtkAlgorithmOutput* marks);

  ///@{
  /// From the last mark back to the first as well. Default off.
  vtkSetMacro(Closed, bool);
  vtkGetMacro(Closed, bool);
  vtkBooleanMacro(Closed, bool);
  ///@}

protected:
  vtkHapticSurfacePath();
  ~vtkHapticSurfacePath() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  bool Closed = false;
};

#endif
