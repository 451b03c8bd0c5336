// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticMechanismSource_h
#define vtkHapticMechanismSource_h

#include "vtkHapticHandedSource.h"
#include "vtkHapticSourceWatch.h"

#include <memory>

/// The mechanism, as it is at first; the bodies of its source are shown where the session has them. A source on a
/// server is brought here each time it has made something else; its bodies are shown where they are at first. None of
/// it is touched as a surface.
class vtkHapticMechanismSource : public vtkHapticHandedSource
{
public:
  vtkHapticMechanismSource() : vtkHapticHandedSource("MechanismSource") {}
  void Follow(vtkHapticSession& session, vtkSMProxy* view) override;
  void Change(vtkHapticSession* session, vtkSMProxy* view, vtkHapticViewScan& scan) override;

private:
  /// The last output of the source of that name, where it is on a server; else null.
  [[nodiscard]] vtkDataObject* Bring(vtkSMProxy* view, const std::string& name);

  bool Moves = false;                          ///< its bodies are shown elsewhere than at first
  std::unique_ptr<vtkHapticSourceWatch> Watch; ///< of one on a server
  vtkSmartPointer<vtkDataObject> Brought;      ///< from there
};

#endif
