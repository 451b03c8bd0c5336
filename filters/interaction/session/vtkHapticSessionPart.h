// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkHapticSessionPart
 * @brief   a subject of a session that has methods of its own
 *
 * A session hands out a new one each time it is asked, they all have the same state, and each keeps the session.
 */
#ifndef vtkHapticSessionPart_h
#define vtkHapticSessionPart_h

#include "vtkHapticInteractionModule.h" // for the export macro
#include "vtkHapticSession.h"
#include "vtkObject.h"
#include "vtkSmartPointer.h" // for the session

class VTKHAPTICINTERACTION_EXPORT vtkHapticSessionPart : public vtkObject
{
public:
  vtkAbstractTypeMacro(vtkHapticSessionPart, vtkObject);

protected:
  explicit vtkHapticSessionPart(vtkHapticSession& session);
  ~vtkHapticSessionPart() override;

#ifndef __VTK_WRAP__
  vtkHapticSession::Internals& Behind() const
  {
    return this->Session->Behind();
  }
#endif

  vtkSmartPointer<vtkHapticSession> Session;
};

#endif
