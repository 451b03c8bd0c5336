// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticServerProxies_h
#define vtkHapticServerProxies_h

#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

class vtkSMProxy;
class vtkSMSourceProxy;

/// A filter in the session of another proxy; null where there is none of that name.
[[nodiscard]] vtkSmartPointer<vtkSMSourceProxy> vtkHapticMakeProxy(
  vtkSMProxy* beside, const char* group, const char* name);

/// The output of a source on a server at a time of the pipeline, on its first rank, brought here; null where nothing
/// came. Waits for it.
[[nodiscard]] vtkSmartPointer<vtkDataObject> vtkHapticBring(vtkSMSourceProxy* source, int type, double time);

#endif
