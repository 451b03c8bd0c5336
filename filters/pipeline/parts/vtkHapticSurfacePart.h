// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticSurfacePart_h
#define vtkHapticSurfacePart_h

#include <array>
#include <optional>
#include <string>

#include "vtkHapticPipelineModule.h" // for the export macro
#include "vtkType.h"

class vtkDataObject;

/// Description of a surface that was cut out of another, or is all of it: sent with it.
struct vtkHapticPartInfo
{
  int Number = 0;                 ///< of the request
  vtkIdType CellsOfAll = 0;       ///< polygons and strips of the whole, on all ranks
  bool Whole = false;             ///< it is all of it
  std::array<double, 3> Centre{}; ///< within `Reach` along each axis of there everything is here, in the data's frame
  double Reach = 0.0;             ///< [u]
  std::array<double, 6> Bounds{}; ///< of the whole: low and high x, y, z [u]
  std::string Version;            ///< of the plugin that cut it
};

/// Writes it on data; and reads it from there: none where it was not written.
VTKHAPTICPIPELINE_EXPORT void vtkHapticTellPart(const vtkHapticPartInfo& info, vtkDataObject* data);
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT std::optional<vtkHapticPartInfo> vtkHapticPartOf(vtkDataObject* data);

/// "", or a message that a server's plugin has another version, with the remedy. Empty `version`: there was no answer.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT std::string vtkHapticOtherVersion(const std::string& version);

#endif
