// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkHapticPlaceInWorkSpace
 * @brief   puts data where an arm is best
 *
 * The middle of the data goes to the place of the work space where the condition of the arm's Jacobian is least, in
 * metres of the device frame times Scale. With Fit the data are scaled so that their box lies in a ball about that
 * place that does not leave the work space.
 */
#ifndef vtkHapticPlaceInWorkSpace_h
#define vtkHapticPlaceInWorkSpace_h

#include <string> // for the file

#include "vtkHapticPipelineModule.h" // for the export macro
#include "vtkPointSetAlgorithm.h"

class VTKHAPTICPIPELINE_EXPORT vtkHapticPlaceInWorkSpace : public vtkPointSetAlgorithm
{
public:
  static vtkHapticPlaceInWorkSpace* New();
  vtkTypeMacro(vtkHapticPlaceInWorkSpace, vtkPointSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// An arm file, or the name of an arm that is built in. Default "falcon".
  vtkSetMacro(Arm, std::string);
  vtkGetMacro(Arm, std::string);
  ///@}

  ///@{
  /// Length of a metre in the output. Default 1.
  vtkSetClampMacro(Scale, double, 1e-300, 1e300);
  vtkGetMacro(Scale, double);
  ///@}

  ///@{
  /// Also scales the data into the work space. Default on.
  vtkSetMacro(Fit, bool);
  vtkGetMacro(Fit, bool);
  vtkBooleanMacro(Fit, bool);
  ///@}

protected:
  vtkHapticPlaceInWorkSpace();
  ~vtkHapticPlaceInWorkSpace() override;

  int RequestData(vtkInformation*, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  std::string Arm = "falcon";
  double Scale = 1.0;
  bool Fit = true;
};

#endif
