// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticSnapPlaces_h
#define vtkHapticSnapPlaces_h

#include <string>

#include "haptics/session/scene/ComparedField.h"

class vtkDataObject;

struct vtkHapticSnapPlacesResult
{
  palpate::SnapPlaces Places;
  std::string Problem; ///< why there are none
};

/// The pieces of all lines in data, and the points of its vertices; without any cells all points. Faces and cells are
/// nothing that a hand could snap to.
vtkHapticSnapPlacesResult vtkHapticToSnapPlaces(vtkDataObject* data);

#endif
