// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticAskedField_h
#define vtkHapticAskedField_h

#include <string>

class vtkDataObject;
class vtkHapticSession;

/// Whether a session names any array in space to feel.
bool vtkHapticAsksForField(const vtkHapticSession& session);

/// Whether data have all arrays that it names; of what the values are compared with only where that is in the same
/// data.
bool vtkHapticHasFieldArrays(vtkDataObject* data, const vtkHapticSession& session);

/// That nothing that is shown has all of them.
std::string vtkHapticLackOfField(const vtkHapticSession& session);

#endif
