// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkHapticStroke
 * @brief   a stroke over a surface: the polyline that leads a hand just under it
 *
 * Looks down on the surface along -Up and cuts it by the plane through Up and Along: the outermost points of the cut
 * over evenly spaced places are a profile. Its longest part without a gap and without a cliff (a step between two
 * places of more than three times their distance) is kept, the middle Reach of that is taken, smoothed over Window and
 * pushed in by Depth along its local normal. Smoothing is an erosion followed by a mean over the same window: it never
 * rises above the surface. Deterministic, whatever the order of triangles.
 *
 * A proxy begins where the hand begins, on that side of the surface. So the stroke starts with a point that lies Lift
 * outside of its first place: a hand that goes back and forth comes down, strokes there and back, and lifts.
 *
 * Points carry the array "Depth" [u]: how far below the profile each lies, along the normal; -Lift at the first.
 */
#ifndef vtkHapticStroke_h
#define vtkHapticStroke_h

#include "vtkHapticPipelineModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

class VTKHAPTICPIPELINE_EXPORT vtkHapticStroke : public vtkPolyDataAlgorithm
{
public:
  static vtkHapticStroke* New();
  vtkTypeMacro(vtkHapticStroke, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Where the hand comes from, any length > 0. Default (0, 0, 1).
  vtkSetVector3Macro(Up, double);
  vtkGetVector3Macro(Up, double);
  ///@}

  ///@{
  /// Where the stroke goes; its part across Up counts and must not vanish. Default (0, 1, 0).
  vtkSetVector3Macro(Along, double);
  vtkGetVector3Macro(Along, double);
  ///@}

  ///@{
  /// A point of the cutting plane [u]; used with UseCentre off. Default (0, 0, 0).
  vtkSetVector3Macro(Origin, double);
  vtkGetVector3Macro(Origin, double);
  ///@}

  ///@{
  /// Cut through the centre of the surface's bounds. Default on.
  vtkSetMacro(UseCentre, bool);
  vtkGetMacro(UseCentre, bool);
  vtkBooleanMacro(UseCentre, bool);
  ///@}

  ///@{
  /// How far under the surface the hand is led [u], >= 0. Default 1.
  vtkSetMacro(Depth, double);
  vtkGetMacro(Depth, double);
  ///@}

  ///@{
  /// How far outside the surface the stroke starts [u], >= 0; 0: under it, without the first point. Default 10.
  vtkSetMacro(Lift, double);
  vtkGetMacro(Lift, double);
  ///@}

  ///@{
  /// Distance of neighbouring places along Along [u], > 0. Default 1.
  vtkSetMacro(Step, double);
  vtkGetMacro(Step, double);
  ///@}

  ///@{
  /// Length over which the profile is smoothed [u], >= 0. Default 10.
  vtkSetMacro(Window, double);
  vtkGetMacro(Window, double);
  ///@}

  ///@{
  /// Fraction of the longest part that is stroked, around its middle, in (0, 1]. Default 0.6.
  vtkSetMacro(Reach, double);
  vtkGetMacro(Reach, double);
  ///@}

protected:
  vtkHapticStroke() = default;
  ~vtkHapticStroke() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  /// Null, or the fault of the numbers.
  const char* CheckNumbers() const;

  double Up[3] = { 0.0, 0.0, 1.0 };
  double Along[3] = { 0.0, 1.0, 0.0 };
  double Origin[3] = { 0.0, 0.0, 0.0 };
  bool UseCentre = true;
  double Depth = 1.0;
  double Lift = 10.0;
  double Step = 1.0;
  double Window = 10.0;
  double Reach = 0.6;
};

#endif
