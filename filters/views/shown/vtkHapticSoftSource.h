// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticSoftSource_h
#define vtkHapticSoftSource_h

#include "vtkHapticHandedSource.h"

#include <optional>

/// The soft body, at rest; its source is bent as the session has it. Its surface at rest is touched: the session knows
/// where that has gone.
class vtkHapticSoftSource : public vtkHapticHandedSource
{
public:
  vtkHapticSoftSource() : vtkHapticHandedSource("SoftSource") {}
  void Follow(vtkHapticSession& session, vtkSMProxy* view) override;
  /// Puts its surface at rest in the place of the one that is shown, or of a skin that rides on it.
  void Change(vtkHapticSession* session, vtkSMProxy* view, vtkHapticViewScan& scan) override;

private:
  std::optional<vtkHapticViewScan::Surface> AtRest;
  vtkSmartPointer<vtkDataObject> AtRestOf; ///< the body whose surface that is
};

#endif
