// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticMechanismSource_h
#define vtkHapticMechanismSource_h

#include "vtkDataObject.h"
#include "vtkHapticSourceWatch.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <string>

class vtkHapticSession;
struct vtkHapticViewScan;
class vtkSMProxy;

/// Keeps the mechanism of a session the same as what its source in the pipeline has made, and the source's bodies where
/// the session has them. A source on a server is brought here each time it has made something else; its bodies are
/// shown where they are at first. None of it is touched as a surface.
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
  /// What the source of that name made last, where it is on a server; else null.
  [[nodiscard]] vtkDataObject* Bring(vtkSMProxy* view, const std::string& name);

  bool Known = false;
  bool Moves = false;                          ///< its bodies are shown elsewhere than at first
  vtkSmartPointer<vtkDataObject> AtFirst;      ///< that the session has
  vtkMTimeType Time = 0;                       ///< of what a filter made of one
  std::string Reason;                          ///< why there is none
  std::string Name;                            ///< whose
  std::unique_ptr<vtkHapticSourceWatch> Watch; ///< of one on a server
  vtkSmartPointer<vtkDataObject> Brought;      ///< from there
};

#endif
