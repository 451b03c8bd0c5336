// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkHapticArm
 * @brief   a haptic arm, and what it can do in its work space
 *
 * Output 0: the links as lines, with the tip where the hand is. Output 1: points of the work space that the arm
 * reaches, with the arrays Condition, LargestForce [N] (in the worst direction) and ApparentMass [kg] (in the heaviest
 * direction). Both in metres of the device frame times Scale.
 */
#ifndef vtkHapticArm_h
#define vtkHapticArm_h

#include <string> // for the file

#include "vtkHapticPipelineModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

class VTKHAPTICPIPELINE_EXPORT vtkHapticArm : public vtkPolyDataAlgorithm
{
public:
  static vtkHapticArm* New();
  vtkTypeMacro(vtkHapticArm, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// An arm file, or the name of an arm that is built in. Default "falcon".
  vtkSetMacro(Arm, std::string);
  vtkGetMacro(Arm, std::string);
  ///@}

  ///@{
  /// Where the hand is, from the middle of the work space [m].
  vtkSetVector3Macro(Hand, double);
  vtkGetVector3Macro(Hand, double);
  ///@}

  ///@{
  /// Points along the diameter of the work space, 2 to 60. Default 12.
  vtkSetClampMacro(Steps, int, 2, 60);
  vtkGetMacro(Steps, int);
  ///@}

  ///@{
  /// Length of a metre in the output. Default 1.
  vtkSetClampMacro(Scale, double, 1e-300, 1e300);
  vtkGetMacro(Scale, double);
  ///@}

protected:
  vtkHapticArm();
  ~vtkHapticArm() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override;

private:
  std::string Arm = "falcon";
  double Hand[3] = { 0.0, 0.0, 0.0 };
  int Steps = 12;
  double Scale = 1.0;
};

#endif
