// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkImageCurves
 * @brief   curves of a flat image, a slice, a label map or a scanned drawing, to be touched as a plane world
 *
 * Input: image data that extends along two axes of its grid, anywhere in space: any origin, spacing and direction.
 * Three or four values a pixel count as a colour, of which the luminance is taken. Output: poly data in place of the
 * image, one cell a curve, closed ones (the first point is also the last) and open ones, with the cell arrays
 *
 *     Error   (n) double  Hausdorff distance between the curve and the one before it was simplified [u], a bound
 *     Closed  (n) int     1 where the curve ends where it begins
 *
 * and the field array Tolerance (1) double, the tolerance that was set [u]. Three kinds of image:
 *
 *   Contour: where the values pass Value, between the pixels by linear interpolation. For a field with the level
 *   set of a circle of radius R on pixels of size h, points are off by at most h^2 / (8 R) and the segments between
 *   them by h^2 / (4 R).
 *   Labels: borders of the areas with the same value, half way between the pixels; a border of two areas is one curve,
 *   and curves end where three areas meet.
 *   Drawing: the middle lines of strokes. Pixels on the ink's side of Value are thinned to lines of one pixel
 *   (Guo & Hall 1989), hooks are left out and ends joined over gaps no longer than Gap: the blank between the tip of a
 *   stroke and the next one, however wide they are.
 *
 * Simplified after Douglas & Peucker 1973 within Tolerance, or within the least depth that can be felt: LeastForce /
 * Stiffness, times the scene units per metre of the hand. Simplified curves may touch or cross where the given ones
 * come nearer to each other than twice the tolerance. No lines at pixels that are not finite. Bad input is an error of
 * one line and leaves the output empty. Reports progress and ends early when asked to.
 */
#ifndef vtkImageCurves_h
#define vtkImageCurves_h

#include "vtkHapticPipelineModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

namespace palpate
{
struct LooseLines;
}
class vtkDataArray;
class vtkHapticImagePlane;
class vtkImageData;

class VTKHAPTICPIPELINE_EXPORT vtkImageCurves : public vtkPolyDataAlgorithm
{
public:
  static vtkImageCurves* New();
  vtkTypeMacro(vtkImageCurves, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Kinds
  {
    Contour = 0,
    Labels = 1,
    Drawing = 2
  };
  enum Tolerances
  {
    ByLength = 0,
    ByFeel = 1
  };

  ///@{
  /// Kind of the image. Default Contour.
  vtkSetClampMacro(Kind, int, Contour, Drawing);
  vtkGetMacro(Kind, int);
  ///@}

  ///@{
  /// Take the value half way between the least and the largest for Value. Default on.
  vtkSetMacro(UseMiddle, bool);
  vtkGetMacro(UseMiddle, bool);
  vtkBooleanMacro(UseMiddle, bool);
  ///@}

  ///@{
  /// The value contoured, or the threshold between ink and paper; used with UseMiddle off. Default 0.5.
  vtkSetMacro(Value, double);
  vtkGetMacro(Value, double);
  ///@}

  ///@{
  /// Ink is darker than paper, i.e. below the value. Default on.
  vtkSetMacro(InkIsDark, bool);
  vtkGetMacro(InkIsDark, bool);
  vtkBooleanMacro(InkIsDark, bool);
  ///@}

  ///@{
  /// Longest gap in a drawing that is closed, and below which hooks are left out [u], >= 0. Default 0: none.
  vtkSetMacro(Gap, double);
  vtkGetMacro(Gap, double);
  ///@}

  ///@{
  /// Curves shorter than this are left out [u], >= 0. Default 0: none.
  vtkSetMacro(ShortestCurve, double);
  vtkGetMacro(ShortestCurve, double);
  ///@}

  ///@{
  /// Tolerance by length or by perceptible force. Default ByLength.
  vtkSetClampMacro(SimplifyBy, int, ByLength, ByFeel);
  vtkGetMacro(SimplifyBy, int);
  ///@}

  ///@{
  /// How far a simplified curve may be from the one given [u], >= 0. Default 0: only points on straight lines go.
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /// The least force that is felt [N], >= 0, default 0.07; the stiffness of the lines [N/m], > 0, default 500; and
  /// scene units per metre of the hand, > 0, default 1.
  vtkSetMacro(LeastForce, double);
  vtkGetMacro(LeastForce, double);
  vtkSetMacro(Stiffness, double);
  vtkGetMacro(Stiffness, double);
  vtkSetMacro(Scale, double);
  vtkGetMacro(Scale, double);
  ///@}

  /// More of a drawing than this share is rarely its lines: then there is a warning.
  static constexpr double MostInk = 0.5;
  /// The share of ink in the image that was a drawing last, 0..1.
  vtkGetMacro(InkShare, double);

  /// How far a simplified curve may be from the one given, with the numbers as they are set [u].
  double GetAllowedError() const;

protected:
  vtkImageCurves();
  ~vtkImageCurves() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(vtkInformation*, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  /// Null, or the fault of the numbers.
  const char* CheckNumbers() const;
  /// The array chosen, or the active one where none is; null where there is none.
  vtkDataArray* ValuesOf(vtkImageData* image, vtkInformationVector** input);
  /// The value between the two sides of a curve; throws where no pixel is on one of them.
  double ChooseValue(const vtkHapticImagePlane& plane) const;
  /// In pixel coordinates; throws std::runtime_error.
  palpate::LooseLines FindLines(const vtkHapticImagePlane& plane);
  /// Throws std::runtime_error.
  void MakeCurves(vtkImageData* image, vtkDataArray* values, vtkPolyData* output);
  /// Reports progress; false when someone asked to stop.
  bool Goes(double progress);

  int Kind = Contour;
  bool UseMiddle = true;
  double Value = 0.5;
  bool InkIsDark = true;
  double Gap = 0.0;
  double ShortestCurve = 0.0;
  int SimplifyBy = ByLength;
  double Tolerance = 0.0;
  double LeastForce = 0.07;
  double Stiffness = 500.0;
  double Scale = 1.0;
  double InkShare = 0.0;
};

#endif
