// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticLabelSurfaces_h
#define vtkHapticLabelSurfaces_h

#include "vtkHapticPipelineModule.h" // for the export macro
#include "vtkMultiBlockDataSetAlgorithm.h"

/**
 * @class vtkHapticLabelSurfaces
 * @brief One closed surface for each label of a label map.
 *
 * Input: an image whose active point scalars are whole numbers, one a voxel. Output: a block for each value but the
 * background, from the least up, named "label N", with the cell array Label: the surface half a voxel outside of the
 * label's voxels, at the image's place whatever its direction, closed at the image's border too, its triangles turned
 * outwards. Smoothing takes the steps of the voxels off (Taubin 1995), and with them less than a voxel.
 */
class VTKHAPTICPIPELINE_EXPORT vtkHapticLabelSurfaces : public vtkMultiBlockDataSetAlgorithm
{
public:
  static vtkHapticLabelSurfaces* New();
  vtkTypeMacro(vtkHapticLabelSurfaces, vtkMultiBlockDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The value of the background. Default 0.
  vtkSetMacro(Background, double);
  vtkGetMacro(Background, double);
  ///@}

  ///@{
  /// Rounds of smoothing, 0 to 1000. Default 20.
  vtkSetClampMacro(Smoothing, int, 0, 1000);
  vtkGetMacro(Smoothing, int);
  ///@}

protected:
  vtkHapticLabelSurfaces();
  ~vtkHapticLabelSurfaces() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  double Background = 0.0;
  int Smoothing = 20;
};

#endif
