// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkHapticLabyrinth
 * @brief   a plane world of the gallery, or of a person's own file, as lines
 *
 * The lines and a fence round them, so that nobody goes round a maze, with the field arrays Start and Exit (3, [u])
 * where it is one, and Corridor (1, [u]). A structure to explore lacks start or exit.
 */
#ifndef vtkHapticLabyrinth_h
#define vtkHapticLabyrinth_h

#include <string> // for the world

#include "vtkHapticPipelineModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

class VTKHAPTICPIPELINE_EXPORT vtkHapticLabyrinth : public vtkPolyDataAlgorithm
{
public:
  static vtkHapticLabyrinth* New();
  vtkTypeMacro(vtkHapticLabyrinth, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// A name of the gallery, or a file: vtp, svg, png and all other types that readers of surfaces know. Default
  /// "corridor".
  vtkSetMacro(World, std::string);
  vtkGetMacro(World, std::string);
  ///@}

  ///@{
  /// How wide its corridors are [u]: the disc that is led through them has a fifth of that as its radius. 0 (default):
  /// as the file says, else as wide as the narrowest place of the widest path from start to exit.
  vtkSetClampMacro(Corridor, double, 0.0, 1e300);
  vtkGetMacro(Corridor, double);
  ///@}

  ///@{
  /// The gallery installed beside this program.
  static int GetNumberOfWorlds();
  static std::string GetWorldName(int index);
  ///@}

protected:
  vtkHapticLabyrinth();
  ~vtkHapticLabyrinth() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override;

private:
  std::string World = "corridor";
  double Corridor = 0.0;
};

#endif
