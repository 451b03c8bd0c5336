// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkHapticSoftSkin
 * @brief   a fine surface that rides on coarse tetrahedra
 *
 * Port 0: the surface as it is at rest (poly data), as fine as it is to be seen. Port 1: a body that vtkHapticSoftBody
 * made, as it is bent now. Output: the surface, each point of which goes as the tetrahedron that it was in goes (by its
 * barycentric coordinates there; a point in none follows the nearest, continued beyond its faces), and dented by the
 * ball that presses the body, with
 *
 *     Displacement  (n, 3) double how far the tetrahedra carry it [u]
 *     Dent          (n, 3) double how much further it is shown, where something presses [u]
 *
 * A session feels the body in its place. Text says which details the coarse tetrahedra leave out.
 */
#ifndef vtkHapticSoftSkin_h
#define vtkHapticSoftSkin_h

#include "vtkHapticPipelineModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for the implementation
#include <string> // for the return type

class vtkUnstructuredGrid;

class VTKHAPTICPIPELINE_EXPORT vtkHapticSoftSkin : public vtkPolyDataAlgorithm
{
public:
  static vtkHapticSoftSkin* New();
  vtkTypeMacro(vtkHapticSoftSkin, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// How far the tetrahedra are from the surface; empty before it has run.
  const char* GetText() const { return this->Text.c_str(); }

  /// Whether data are an output of this filter.
  static bool IsSkin(vtkDataObject* data);

protected:
  vtkHapticSoftSkin();
  ~vtkHapticSoftSkin() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  /// Finds each point's tetrahedron, unless surface and body at rest are those of before. False with a problem.
  bool Ride(vtkPolyData& surface, vtkUnstructuredGrid& body, std::string& problem);

  std::string Text;
  struct Riders;
  std::unique_ptr<Riders> Kept;
};

#endif
