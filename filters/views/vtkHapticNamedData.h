// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticNamedData_h
#define vtkHapticNamedData_h

#include <string>

class vtkDataObject;
class vtkSMProxy;

/// What a source of the pipeline browser makes at its first output, shown or not, at the time of a view; null where
/// there is none of that name or its data are not here.
vtkDataObject* vtkHapticNamedData(vtkSMProxy* view, const std::string& name);

#endif
