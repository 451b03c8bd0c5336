// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkHapticNeedle
 * @brief   a straight rod with a point, to hold as a tool or in a mechanism
 *
 * A closed surface about the z axis whose triangles face outward. The needle hangs below the origin, where a hand holds
 * it, and ends in a point at z = -Length, rigid.
 */
#ifndef vtkHapticNeedle_h
#define vtkHapticNeedle_h

#include "vtkHapticPipelineModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

class VTKHAPTICPIPELINE_EXPORT vtkHapticNeedle : public vtkPolyDataAlgorithm
{
public:
  static vtkHapticNeedle* New();
  vtkTypeMacro(vtkHapticNeedle, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// From the hand to the point [u], more than the point's own, which is 1.5 diameters. Default 150.
  vtkSetMacro(Length, double);
  vtkGetMacro(Length, double);
  ///@}

  ///@{
  /// Of the shaft [u], > 0. Default 1.2.
  vtkSetMacro(Diameter, double);
  vtkGetMacro(Diameter, double);
  ///@}

  ///@{
  /// Corners around the axis, 3 to 256. Default 16.
  vtkSetClampMacro(Resolution, int, 3, 256);
  vtkGetMacro(Resolution, int);
  ///@}

protected:
  vtkHapticNeedle();
  ~vtkHapticNeedle() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override;

  double Length = 150.0;
  double Diameter = 1.2;
  int Resolution = 16;
};

#endif
