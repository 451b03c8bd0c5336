// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkHapticToolShape
 * @brief   a tool to hold, or its counterpart: peg and hole, screw and nut, burr
 *
 * Closed surfaces whose triangles face outward, about the z axis. Peg, screw and burr hang below the origin, where a
 * hand holds them; hole and nut have their mouth in the plane z = 0 and are wider than their partner by Clearance,
 * radially: there a partner of the same sizes fits as it is. A screw is right-handed; turned by an angle it advances by
 * Pitch angle / 2 pi.
 */
#ifndef vtkHapticToolShape_h
#define vtkHapticToolShape_h

#include "vtkHapticPipelineModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

class VTKHAPTICPIPELINE_EXPORT vtkHapticToolShape : public vtkPolyDataAlgorithm
{
public:
  static vtkHapticToolShape* New();
  vtkTypeMacro(vtkHapticToolShape, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ShapeChoices
  {
    Peg,
    Hole,
    Screw,
    Nut,
    Burr
  };

  ///@{
  /// Which one. Default Peg.
  vtkSetClampMacro(Shape, int, Peg, Burr);
  vtkGetMacro(Shape, int);
  ///@}

  ///@{
  /// Of the peg, of the screw's core, of the burr's ball [u], > 0. Default 5.
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /// How far it hangs down, or how deep the hole and the nut are [u], > 0; a burr's is more than twice its radius.
  /// Default 20.
  vtkSetMacro(Length, double);
  vtkGetMacro(Length, double);
  ///@}

  ///@{
  /// Radial clearance of hole and nut [u], > 0. Default 0.1.
  vtkSetMacro(Clearance, double);
  vtkGetMacro(Clearance, double);
  ///@}

  ///@{
  /// Of the end of the peg and of the mouth of the hole, at 45 degrees [u], 0 to less than Radius and Length.
  /// Default 1.
  vtkSetMacro(Chamfer, double);
  vtkGetMacro(Chamfer, double);
  ///@}

  ///@{
  /// From one turn of the thread to the next [u], > 0; the thread is half as high. Default 4.
  vtkSetMacro(Pitch, double);
  vtkGetMacro(Pitch, double);
  ///@}

  ///@{
  /// Corners around the axis, 3 to 64 for each of the eight parts of a turn. Default 6.
  vtkSetClampMacro(Resolution, int, 3, 64);
  vtkGetMacro(Resolution, int);
  ///@}

protected:
  vtkHapticToolShape();
  ~vtkHapticToolShape() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override;

private:
  int Shape = Peg;
  double Radius = 5.0;
  double Length = 20.0;
  double Clearance = 0.1;
  double Chamfer = 1.0;
  double Pitch = 4.0;
  int Resolution = 6;
};

#endif
