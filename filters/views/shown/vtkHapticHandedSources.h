// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticHandedSources_h
#define vtkHapticHandedSources_h

#include "vtkHapticFollowingArms.h"
#include "vtkHapticLooseSources.h"
#include "vtkHapticMechanismSource.h"
#include "vtkHapticSoftSource.h"
#include "vtkHapticToolSource.h"

#include <tuple>

/// Sources that are more than a surface for a session: its tool, its soft body and its mechanism, which it names, those
/// that are loose, and the arms that are drawn at its hand.
class vtkHapticHandedSources
{
public:
  void Follow(vtkHapticSession& session, vtkSMProxy* view)
  {
    std::apply([&](auto&... source) { (source.Follow(session, view), ...); }, this->Sources);
  }
  void Forget()
  {
    std::apply([](auto&... source) { (source.Forget(), ...); }, this->Sources);
  }
  /// The parts of them that are touched as surfaces.
  void Change(vtkHapticSession* session, vtkSMProxy* view, vtkHapticViewScan& scan)
  {
    std::apply([&](auto&... source) { (source.Change(session, view, scan), ...); }, this->Sources);
  }

private:
  std::tuple<vtkHapticToolSource, vtkHapticMechanismSource, vtkHapticSoftSource, vtkHapticLooseSources,
    vtkHapticFollowingArms>
    Sources;
};

#endif
