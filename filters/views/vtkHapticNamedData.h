// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticNamedData_h
#define vtkHapticNamedData_h

#include <string>

class vtkDataObject;
class vtkSMProxy;

/// What a source of the pipeline browser makes, shown or not, brought up to date; null where there is none of that name
/// or its data are not here. `any`: a proxy of the same pipeline.
vtkDataObject* vtkHapticNamedData(vtkSMProxy* any, const std::string& name);

#endif
