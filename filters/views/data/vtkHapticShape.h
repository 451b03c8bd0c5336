// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticShape_h
#define vtkHapticShape_h

#include <string>

#include "vtkDataObject.h" // for the member
#include "vtkSmartPointer.h"

/// The geometry that a mapper without polygons of its own draws, in the frame of its actor; or why there is none.
struct vtkHapticShape
{
  vtkSmartPointer<vtkDataObject> Data; ///< null on Problem
  std::string Problem;                 ///< one line without a name in front
};

#endif
