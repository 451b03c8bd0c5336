// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticMeasuredSurface_h
#define vtkHapticMeasuredSurface_h

#include <memory>
#include <string>

#include "haptics/geometry/tree/SurfaceTree.h"

class vtkDataObject;

/// The triangles of a data object as a tree that can be measured, cleaned as they are for touching; null with a
/// `problem`, one line.
[[nodiscard]] std::shared_ptr<const palpate::SurfaceTree> vtkHapticMeasuredSurface(
  vtkDataObject* data, std::string& problem);

#endif
