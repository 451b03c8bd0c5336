// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticLabyrinthData_h
#define vtkHapticLabyrinthData_h

#include <optional>
#include <string>

#include "haptics/labyrinth/Labyrinth.h"
#include "vtkHapticPipelineModule.h" // for the export macro

class vtkDataObject;

/// A labyrinth, or why there is none.
struct vtkHapticLabyrinthResult
{
  palpate::Labyrinth Labyrinth; ///< named as it was asked for
  std::string Note;             ///< a remark on the file for a person, without its name; may be empty
  std::string Problem;          ///< one line that begins with the name; empty when it can be explored
};

/// The lines of a data object in the plane z = 0, with the first tuples of its field arrays Start and Exit, if it has
/// them, and corridors of corridor_u if that is given, else its Corridor, else the result of corridorWidth() [scene
/// units]. A structure without start and exit is a result too; a world that refuseWorld() refuses is a problem.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkHapticLabyrinthResult vtkHapticToLabyrinth(
  vtkDataObject* data, const std::string& name, std::optional<double> corridor_u = std::nullopt);

/// The same of a file that ParaView's readers of surfaces know.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT vtkHapticLabyrinthResult vtkHapticReadLabyrinth(
  const std::string& file, std::optional<double> corridor_u = std::nullopt);

#endif
