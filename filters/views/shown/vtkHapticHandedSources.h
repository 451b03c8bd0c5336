// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticHandedSources_h
#define vtkHapticHandedSources_h

#include "vtkHapticSoftSource.h"
#include "vtkHapticToolSource.h"

/// Sources that a session names and takes as more than a surface: its tool, and what gives way.
class vtkHapticHandedSources
{
public:
  void Follow(vtkHapticSession& session, vtkSMProxy* view)
  {
    this->Tool.Follow(session, view);
    this->Soft.Follow(session, view);
  }
  void Forget()
  {
    this->Tool.Forget();
    this->Soft.Forget();
  }
  /// What of them is touched as a surface.
  void Change(vtkHapticSession* session, vtkHapticViewScan& scan)
  {
    vtkHapticToolSource::LeaveOut(session, scan);
    this->Soft.KeepAtRest(session, scan);
  }

private:
  vtkHapticToolSource Tool;
  vtkHapticSoftSource Soft;
};

#endif
