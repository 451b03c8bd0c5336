// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticHandedSources_h
#define vtkHapticHandedSources_h

#include "vtkHapticMechanismSource.h"
#include "vtkHapticSoftSource.h"
#include "vtkHapticToolSource.h"

#include <tuple>

/// Sources that a session names and takes as more than a surface: its tool, its soft body, and its mechanism.
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
  void Change(vtkHapticSession* session, vtkHapticViewScan& scan)
  {
    std::apply([&](auto&... source) { (source.Change(session, scan), ...); }, this->Sources);
  }

private:
  std::tuple<vtkHapticToolSource, vtkHapticMechanismSource, vtkHapticSoftSource> Sources;
};

#endif
