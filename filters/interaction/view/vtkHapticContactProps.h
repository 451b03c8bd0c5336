// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticContactProps_h
#define vtkHapticContactProps_h

#include "vtkActor.h"
#include "vtkGlyph3DMapper.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

class vtkHapticSession;

/// Arrows at the contacts of a tool, along the force there on it, in a colour for each surface or body that is touched.
class vtkHapticContactProps
{
public:
  vtkHapticContactProps();

  vtkNew<vtkActor> Arrows;

  /// Visible where the session has ShowContactForces, and something presses. `perNewton`: length of an arrow [u/N].
  void UpdateFrom(vtkHapticSession* session, double perNewton);

private:
  vtkNew<vtkPolyData> Forces;
  vtkNew<vtkGlyph3DMapper> Mapper;
};

#endif
