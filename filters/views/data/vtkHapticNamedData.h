// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticNamedData_h
#define vtkHapticNamedData_h

#include <string>

#include "vtkHapticViewScan.h"

class vtkDataObject;
class vtkObject;
class vtkSMProxy;

/// The data that a representation draws, among its choices.
vtkObject* vtkHapticActiveRepresentation(vtkSMProxy* representation);

/// The source that it shows, and that one's name in the pipeline browser; null and "" for annotations, which have none.
vtkSMProxy* vtkHapticInputOf(vtkSMProxy* representation);
std::string vtkHapticNameOf(vtkSMProxy* source);

/// Of a view, in its order.
std::vector<vtkSMProxy*> vtkHapticVisibleRepresentations(vtkSMProxy* view);

/// Whether a view's data are on a server.
bool vtkHapticIsRemote(vtkSMProxy* view);

/// The output of the input of a representation, here or on a server, under that name.
vtkHapticViewScan::Source vtkHapticShownSource(vtkSMProxy* representation, const std::string& name);

/// The proxy of that name in the pipeline browser of a view; null: there is none.
vtkSMProxy* vtkHapticNamedProxy(vtkSMProxy* view, const std::string& name);

/// The first output of a source of the pipeline browser, shown or not, at the time of a view; without data here and on
/// a server where there is none of that name.
vtkHapticViewScan::Source vtkHapticNamedSource(vtkSMProxy* view, const std::string& name);

/// The same of data that are here; else null.
vtkDataObject* vtkHapticNamedData(vtkSMProxy* view, const std::string& name);

#endif
