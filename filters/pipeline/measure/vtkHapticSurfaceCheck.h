// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticSurfaceCheck_h
#define vtkHapticSurfaceCheck_h

#include "vtkHapticPipelineModule.h" // for the export macro
#include "vtkMultiBlockDataSetAlgorithm.h"

/**
 * @class vtkHapticSurfaceCheck
 * @brief Faults of a surface, to look at before trusting it, as blocks that can be selected in a view.
 *
 * Input: any data with polygons. Output, with the names of its blocks: Surface, its triangles with the cell arrays
 * Flipped (number of the flipped part from 1 on, 0: none) and Thickness [u] (NaN where it is not thin); Holes, the
 * edges of the rims with the cell arrays Hole (from 1 on, the longest first) and Length of the whole rim [u]; Flipped
 * and Thin, the triangles concerned with the same arrays as Surface and Triangle, their number there. See
 * palpate::findFaults().
 */
class VTKHAPTICPIPELINE_EXPORT vtkHapticSurfaceCheck : public vtkMultiBlockDataSetAlgorithm
{
public:
  static vtkHapticSurfaceCheck* New();
  vtkTypeMacro(vtkHapticSurfaceCheck, vtkMultiBlockDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Walls thinner than this are thin [u]; only looked for where there is no hole. Default 0: none is.
  vtkSetMacro(ThinBelow, double);
  vtkGetMacro(ThinBelow, double);
  ///@}

protected:
  vtkHapticSurfaceCheck() = default;
  ~vtkHapticSurfaceCheck() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  double ThinBelow = 0.0;
};

#endif
