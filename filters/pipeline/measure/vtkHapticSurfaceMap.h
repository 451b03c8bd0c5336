// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticSurfaceMap_h
#define vtkHapticSurfaceMap_h

#include "vtkHapticPipelineModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for a member

/**
 * @class vtkHapticSurfaceMap
 * @brief Wall thickness or curvature of a surface around a place, as a point array.
 *
 * Input: poly data with polygons. Output: the same surface with one more point array, which is active: Thickness [u],
 * from the point straight in to the same surface, or Curvature [1/u], the mean of the two principal curvatures, 1/r on
 * the outside of a ball of radius r. With Curvature there are CurvatureLargest and CurvatureLeast. Values are those of
 * palpate::wallThickness_u() and palpate::curvatureAt(), as at a contact.
 *
 * Points have a value where their triangles are within Radius of Centre, see palpate::patchAround(); the others have
 * NaN, as do points without a wall behind them and those with too few vertices around to tell a curvature. Straight in
 * is against the mean normal of the point's triangles, weighted by their areas, however the triangles of a closed
 * surface are turned. On several ranks the first has all of the surface.
 */
class VTKHAPTICPIPELINE_EXPORT vtkHapticSurfaceMap : public vtkPolyDataAlgorithm
{
public:
  static vtkHapticSurfaceMap* New();
  vtkTypeMacro(vtkHapticSurfaceMap, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Quantities
  {
    Thickness,
    Curvature
  };

  ///@{
  /// One of Quantities. Default: Thickness.
  vtkSetClampMacro(Quantity, int, Thickness, Curvature);
  vtkGetMacro(Quantity, int);
  ///@}

  ///@{
  /// The place around which is mapped, in the frame of the data [u].
  vtkSetVector3Macro(Centre, double);
  vtkGetVector3Macro(Centre, double);
  ///@}

  ///@{
  /// Of the map [u]; 0: a tenth of the diagonal of the surface. Default: 0.
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  /// Range of the map, as a sentence; empty before the first output.
  const char* GetText() const { return this->Text.c_str(); }

protected:
  vtkHapticSurfaceMap() = default;
  ~vtkHapticSurfaceMap() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  /// Adds the arrays to a surface; or says why there are none.
  std::string Map(vtkPolyData* surface);

  int Quantity = Thickness;
  double Centre[3] = { 0.0, 0.0, 0.0 };
  double Radius = 0.0;
  std::string Text;
};

#endif
