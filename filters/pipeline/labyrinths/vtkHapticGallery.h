// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticGallery_h
#define vtkHapticGallery_h

#include <string>
#include <vector>

#include "vtkHapticPipelineModule.h" // for the export macro

/// The gallery of plane worlds that comes with the program.
namespace vtkHapticGallery
{
/// Its folder, looked for as share/palpate/gallery beside this library and in the folders above it, which finds it in
/// build and install trees. Empty when it is not there.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT std::string Folder();

/// Names of its worlds in order, "chartres" of chartres.vtp.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT std::vector<std::string> Names();

/// The file of a world by its name; anything else is returned as it is, as the name of a person's own file.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT std::string FileOf(const std::string& nameOrFile);
} // namespace vtkHapticGallery

#endif
