// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticNamedData_h
#define vtkHapticNamedData_h

#include <string>

#include "vtkHapticViewScan.h"

class vtkDataObject;
class vtkSMProxy;

/// What the input of a representation made, here or on a server, under that name.
vtkHapticViewScan::Source vtkHapticShownSource(vtkSMProxy* representation, const std::string& name);

/// What a source of the pipeline browser makes at its first output, shown or not, at the time of a view; without data
/// here and on a server where there is none of that name.
vtkHapticViewScan::Source vtkHapticNamedSource(vtkSMProxy* view, const std::string& name);

/// The same of data that are here; else null.
vtkDataObject* vtkHapticNamedData(vtkSMProxy* view, const std::string& name);

#endif
