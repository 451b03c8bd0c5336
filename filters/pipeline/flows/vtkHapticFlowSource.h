// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkHapticFlowSource
 * @brief   a flow that is known by a formula, on an image or on tetrahedra
 *
 * Point arrays Velocity (3, double) [u/s], by the formula at each point, and Speed (1, double), its length. To try
 * fields with, and to judge them by. The double gyre changes in time: its time steps are a twentieth of a second apart,
 * and any time between them is exact too.
 */
#ifndef vtkHapticFlowSource_h
#define vtkHapticFlowSource_h

#include "vtkDataObjectAlgorithm.h"
#include "vtkHapticPipelineModule.h" // for the export macro

class vtkImageData;
class vtkUnstructuredGrid;

class VTKHAPTICPIPELINE_EXPORT vtkHapticFlowSource : public vtkDataObjectAlgorithm
{
public:
  static vtkHapticFlowSource* New();
  vtkTypeMacro(vtkHapticFlowSource, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum FlowChoices
  {
    ABC,
    TaylorGreen,
    LambOseen,
    DoubleGyre
  };

  enum CellChoices
  {
    Image,
    Tetrahedra
  };

  ///@{
  /// Which flow. Default ABC.
  vtkSetClampMacro(Flow, int, ABC, DoubleGyre);
  vtkGetMacro(Flow, int);
  ///@}

  ///@{
  /// The grid of the samples: the points of an image (default), or the same points joined to tetrahedra, six a voxel.
  vtkSetClampMacro(Cells, int, Image, Tetrahedra);
  vtkGetMacro(Cells, int);
  ///@}

  ///@{
  /// Points along its longest edge, 2 to 1024; the others have as many as make voxels cubes. More than ten
  /// million voxels are not cut into tetrahedra. Default 33.
  vtkSetClampMacro(Resolution, int, 2, 1024);
  vtkGetMacro(Resolution, int);
  ///@}

protected:
  vtkHapticFlowSource();
  ~vtkHapticFlowSource() override = default;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override;

private:
  void WholeExtent(int extent[6]) const;
  void FillImage(const int extent[6], double time, vtkImageData* image) const;
  static void FillTetrahedra(vtkImageData* image, vtkUnstructuredGrid* grid);

  int Flow = ABC;
  int Cells = Image;
  int Resolution = 33;
};

#endif
