// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkHapticArm
 * @brief   a haptic arm, and condition, force and mass in its work space
 *
 * Output 0: the links as lines, with the tip where the hand is. Output 1: points of the work space that the arm
 * reaches, with the arrays Condition, LargestForce [N] (in the worst direction) and ApparentMass [kg] (in the heaviest
 * direction). Both in metres of the device frame times Scale; or in the scene, at the hand of a session, with
 * FollowHand.
 */
#ifndef vtkHapticArm_h
#define vtkHapticArm_h

#include <memory> // for the implementation
#include <string> // for the file

#include "vtkHapticPipelineModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

class vtkMatrix4x4;

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

  ///@{
  /// Whether the arm is drawn at the hand of a session that touches, and not at Hand. Default off. Whatever follows the
  /// session calls ShowHand() then.
  vtkSetMacro(FollowHand, bool);
  vtkGetMacro(FollowHand, bool);
  vtkBooleanMacro(FollowHand, bool);
  ///@}

  /**
   * Has the outputs show the arm with its tip at a hand: its position from the middle of the work space [m], its turn
   * (a quaternion w, x, y, z, for an arm of six joints that can turn its tip so), and where the middle and a metre of
   * the device lie in the scene. A hand out of reach leaves the joints as they were; the first one since ShowTyped() is
   * a warning. ShowTyped() ends it. True if the outputs will be others.
   */
  bool ShowHand(const double hand_D[3], const double turn_D[4], vtkMatrix4x4* toScene);
  bool ShowTyped();

protected:
  vtkHapticArm();
  ~vtkHapticArm() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override;

private:
  class Internals;

  /// False: the arm cannot be read.
  bool Read();
  void WarnOfReach(bool follows);

  std::string Arm = "falcon";
  double Hand[3] = { 0.0, 0.0, 0.0 };
  int Steps = 12;
  double Scale = 1.0;
  bool FollowHand = false;
  std::unique_ptr<Internals> Impl;
};

#endif
