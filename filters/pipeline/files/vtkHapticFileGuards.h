// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticFileGuards_h
#define vtkHapticFileGuards_h

#include <string>

#include "vtkHapticPipelineModule.h" // for the export macro

/// Conditions before a reader may trust a file's header and allocate for it. Each returns an empty string, or the
/// fault.
namespace vtkHapticFileGuards
{
/// Exists, is a regular file, can be opened, holds at least one byte.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT std::string CheckFile(const std::string& path);

/// VTK's XML formats: every count in the headers could be stored, compressed as well as can be, in a file that long.
[[nodiscard]] std::string CheckXMLCounts(const std::string& path);

/// STL: a binary file is as long as its count says; a text ends with `endsolid`.
[[nodiscard]] std::string CheckSTL(const std::string& path);

/// An image of that many bytes could be stored in that file; gzip packs at most 1032 to 1.
[[nodiscard]] std::string CheckImageBytes(
  const std::string& path, const int dimensions[3], double bytesPerVoxel, bool compressed);

/// Throws std::runtime_error with the text of one of them, unless that is empty.
void ThrowIf(const std::string& problem);
} // namespace vtkHapticFileGuards

#endif
