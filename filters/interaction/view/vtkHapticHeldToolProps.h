// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticHeldToolProps_h
#define vtkHapticHeldToolProps_h

#include "vtkActor.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

class vtkHapticSession;

/// Drawing of a tool in the hand, or of the held body of a mechanism: solid at its pose, a ghost where the
/// hand would have it.
class vtkHapticHeldToolProps
{
public:
  vtkHapticHeldToolProps();

  vtkNew<vtkActor> Solid;
  vtkNew<vtkActor> Ghost;

  /// Whether there is one to be seen; it is, then.
  bool UpdateFrom(vtkHapticSession* session);

private:
  vtkNew<vtkPolyData> Shape;
  vtkNew<vtkMatrix4x4> SolidFrame;
  vtkNew<vtkMatrix4x4> GhostFrame;
};

#endif
