// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticMechanismSource_h
#define vtkHapticMechanismSource_h

#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

#include <string>

class vtkHapticSession;
struct vtkHapticViewScan;
class vtkSMProxy;

/// Keeps the mechanism of a session the same as what its source in the pipeline has made, and the source's bodies where
/// the session has them. None of it is touched as a surface.
class vtkHapticMechanismSource
{
public:
  /// Tells the session of another mechanism, or that the source is gone; shows where the bodies are. `view`: of the
  /// pipeline.
  void Follow(vtkHapticSession& session, vtkSMProxy* view);
  /// The next look tells it in any case.
  void Forget() { this->Known = false; }
  static void LeaveOut(vtkHapticSession* session, vtkHapticViewScan& scan);

private:
  bool Known = false;
  bool Moves = false;                     ///< its bodies are shown elsewhere than at first
  vtkSmartPointer<vtkDataObject> AtFirst; ///< that the session has
  vtkMTimeType Time = 0;                  ///< of what a filter made of one
  std::string Reason;                     ///< why there is none
  std::string Name;                       ///< whose
};

#endif
