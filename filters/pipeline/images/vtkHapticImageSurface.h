// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticImageSurface_h
#define vtkHapticImageSurface_h

#include <string>

#include "vtkSmartPointer.h"

class vtkPolyData;

/// The iso surface of the image in a file, at the place that its header gives it. Throws std::runtime_error.
/// `note` receives a remark for a person although the image could be read.
namespace vtkHapticImageSurface
{
[[nodiscard]] vtkSmartPointer<vtkPolyData> ReadVTI(const std::string& path, double iso);
[[nodiscard]] vtkSmartPointer<vtkPolyData> ReadNIfTI(const std::string& path, double iso, std::string& note);
} // namespace vtkHapticImageSurface

#endif
