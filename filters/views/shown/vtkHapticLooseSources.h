// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticLooseSources_h
#define vtkHapticLooseSources_h

#include "vtkMatrix4x4.h"
#include "vtkProp3D.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <string>
#include <utility>
#include <vector>

class vtkHapticSession;
class vtkSMProxy;
struct vtkHapticViewScan;

/// The sources that a session has as loose bodies: each is drawn where the session has it. Its data, and the properties
/// of its display, stay as they are. A display that a server renders stays where its data are. The session is told the
/// unit of lengths of the files, by which such bodies have their mass.
class vtkHapticLooseSources
{
public:
  /// Moves the displays of a view. `view`: of the pipeline.
  void Follow(vtkHapticSession& session, vtkSMProxy* view);
  /// Loose sources are touched where their data are: a body begins there.
  void Change(vtkHapticSession* session, vtkSMProxy* view, vtkHapticViewScan& scan);
  void Forget() { this->Looked = {}; }

private:
  /// A display that is drawn elsewhere than by its properties.
  struct Moved
  {
    std::string Name; ///< of its source
    vtkWeakPointer<vtkProp3D> Prop;
    vtkSmartPointer<vtkMatrix4x4> Own; ///< user's matrix of the prop before, or null
  };
  Moved& MovedOf(const std::string& name, vtkProp3D* prop);
  void TellUnit(vtkHapticSession& session, vtkSMProxy* view);

  std::vector<Moved> Displays;
  std::pair<vtkMTimeType, std::vector<vtkSMProxy*>> Looked; ///< settings, and visible displays, when the unit was told
};

#endif
