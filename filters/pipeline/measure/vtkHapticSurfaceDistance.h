// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticSurfaceDistance_h
#define vtkHapticSurfaceDistance_h

#include "vtkHapticPipelineModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for a member

class vtkAlgorithmOutput;

/**
 * @class vtkHapticSurfaceDistance
 * @brief Compares two surfaces: how far each point of one is from the other.
 *
 * Port 0: the surface, poly data; port 1: the reference, any data with polygons. Output: the surface with the point
 * array Distance [u] to the nearest point of the reference's triangles and, where the reference is closed,
 * SignedDistance [u], below 0 inside of it however its triangles are turned. A point that is not finite gets NaN in
 * both. Either array may be felt as stiffness, friction or texture. Distance is the active array of scalars, by which
 * ParaView colours the surface. The field arrays MeanDistance, RMSDistance and MaximumDistance [u] and the sentence
 * Text have the statistics of Distance over the surface, see vtkHapticMeanOver().
 */
class VTKHAPTICPIPELINE_EXPORT vtkHapticSurfaceDistance : public vtkPolyDataAlgorithm
{
public:
  static vtkHapticSurfaceDistance* New();
  vtkTypeMacro(vtkHapticSurfaceDistance, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void SetReferenceConnection(vtkAlgorithmOutput* reference);

  /// Mean, root mean square and maximum of the distance, as a sentence; empty before the first output.
  const char* GetText() const { return this->Text.c_str(); }

protected:
  vtkHapticSurfaceDistance();
  ~vtkHapticSurfaceDistance() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  std::string Text;
};

#endif
