// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticToolSource_h
#define vtkHapticToolSource_h

#include "vtkHapticHandedSource.h"

/// The tool, shown or hidden. The held mesh is not touched.
class vtkHapticToolSource : public vtkHapticHandedSource
{
public:
  vtkHapticToolSource() : vtkHapticHandedSource("ToolSource") {}
  void Follow(vtkHapticSession& session, vtkSMProxy* view) override;
};

#endif
