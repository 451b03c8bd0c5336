// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticToolSource_h
#define vtkHapticToolSource_h

#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

class vtkHapticSession;
struct vtkHapticViewScan;
class vtkSMProxy;

/// Keeps the tool of a session the same as what its source in the pipeline has made, shown or hidden.
class vtkHapticToolSource
{
public:
  /// Tells the session of other data, or that the source is gone. `view`: of the pipeline.
  void Follow(vtkHapticSession& session, vtkSMProxy* view);
  /// The next look tells it in any case.
  void Forget() { this->Known = false; }
  /// What is in the hand is not touched by it.
  static void LeaveOut(vtkHapticSession* session, vtkHapticViewScan& scan);

private:
  bool Known = false;
  vtkSmartPointer<vtkDataObject> Data; ///< that the session has
  vtkMTimeType Time = 0;
};

#endif
