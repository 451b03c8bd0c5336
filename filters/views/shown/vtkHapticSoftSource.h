// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticSoftSource_h
#define vtkHapticSoftSource_h

#include "vtkDataObject.h"
#include "vtkHapticViewScan.h"
#include "vtkSmartPointer.h"

#include <optional>
#include <string>

class vtkHapticSession;
class vtkSMProxy;

/// Keeps the soft body of a session the same as what its source in the pipeline has made, and the source bent as the
/// session has it. What is touched of it is its surface at rest: where it has gone the session knows.
class vtkHapticSoftSource
{
public:
  /// Tells the session of another body, or that the source is gone; shows how it is bent. `view`: of the pipeline.
  void Follow(vtkHapticSession& session, vtkSMProxy* view);
  /// The next look tells it in any case.
  void Forget() { this->Known = false; }
  /// Puts its surface at rest in the place of the one that is shown, or of a skin that rides on it.
  void KeepAtRest(vtkHapticSession* session, vtkHapticViewScan& scan);

private:
  bool Known = false;
  vtkSmartPointer<vtkDataObject> Body; ///< that the session has, at rest
  std::string Name;                    ///< whose
  std::optional<vtkHapticViewScan::Surface> AtRest;
  vtkSmartPointer<vtkDataObject> AtRestOf; ///< the body whose surface that is
};

#endif
