// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticHandedSources_h
#define vtkHapticHandedSources_h

#include "vtkHapticMechanismSource.h"
#include "vtkHapticSoftSource.h"
#include "vtkHapticToolSource.h"

/// Sources that a session names and takes as more than a surface: its tool, what gives way, and its mechanism.
class vtkHapticHandedSources
{
public:
  void Follow(vtkHapticSession& session, vtkSMProxy* view)
  {
    this->Tool.Follow(session, view);
    this->Soft.Follow(session, view);
    this->Mechanism.Follow(session, view);
  }
  void Forget()
  {
    this->Tool.Forget();
    this->Soft.Forget();
    this->Mechanism.Forget();
  }
  /// What of them is touched as a surface.
  void Change(vtkHapticSession* session, vtkHapticViewScan& scan)
  {
    vtkHapticToolSource::LeaveOut(session, scan);
    vtkHapticMechanismSource::LeaveOut(session, scan);
    this->Soft.KeepAtRest(session, scan);
  }

private:
  vtkHapticToolSource Tool;
  vtkHapticSoftSource Soft;
  vtkHapticMechanismSource Mechanism;
};

#endif
