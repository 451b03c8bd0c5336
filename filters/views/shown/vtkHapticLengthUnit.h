// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticLengthUnit_h
#define vtkHapticLengthUnit_h

#include "vtkHapticViewsModule.h"

#include <string>

class vtkSMProxy;

/// The unit of the lengths of a scene, and a sentence that says where it is from.
struct vtkHapticLengthUnit
{
  std::string Unit = "u"; ///< "u": not known
  std::string Reason;
};

/// Of the sources that a view shows, by the files that their data come from. Formats of medical images have millimetres
/// by their definition; STL has no unit, but parts are made in millimetres, which is taken where their size allows it.
/// Null has none.
VTKHAPTICVIEWS_EXPORT vtkHapticLengthUnit vtkHapticLengthUnitOf(vtkSMProxy* view);

#endif
