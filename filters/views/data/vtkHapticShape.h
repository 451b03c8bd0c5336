// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticShape_h
#define vtkHapticShape_h

#include <string>

#include "vtkDataObject.h" // for the member
#include "vtkSmartPointer.h"

/// What a mapper draws that has no polygons of its own, as geometry in the frame of its actor; or why there is none.
struct vtkHapticShape
{
  vtkSmartPointer<vtkDataObject> Data; ///< null on Problem
  std::string Problem;                 ///< one line without a name in front
};

#endif
