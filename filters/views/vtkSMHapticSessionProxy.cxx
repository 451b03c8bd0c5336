// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkSMHapticSessionProxy.h"

#include "vtkCommand.h"
#include "vtkHapticSession.h"
#include "vtkObjectFactory.h"
#include "vtkSMPropertyHelper.h"

vtkStandardNewMacro(vtkSMHapticSessionProxy);

void vtkSMHapticSessionProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

void vtkSMHapticSessionProxy::CreateVTKObjects()
{
  const bool before = this->GetObjectsCreated() != 0;
  this->Superclass::CreateVTKObjects();
  auto* session = vtkHapticSession::SafeDownCast(before ? nullptr : this->GetClientSideObject());
  if (session)
  {
    session->AddObserver(vtkCommand::PropertyModifiedEvent, this, &vtkSMHapticSessionProxy::ReadBack);
  }
}

void vtkSMHapticSessionProxy::UpdateVTKObjects()
{
  if (this->Telling)
  {
    return;
  }
  this->Telling = true;
  this->Superclass::UpdateVTKObjects();
  this->Superclass::UpdateVTKObjects(); // what was read back meanwhile
  this->Telling = false;
}

void vtkSMHapticSessionProxy::ReadBack()
{
  auto* session = vtkHapticSession::SafeDownCast(this->GetClientSideObject());
  vtkSMPropertyHelper(this, "LinesAsWalls").Set(session->GetLinesAsWalls());
  vtkSMPropertyHelper(this, "Radius").Set(session->GetRadius());
  vtkSMPropertyHelper(this, "Scale").Set(session->GetScale());
  vtkSMPropertyHelper(this, "Rotation").Set(session->GetRotation(), 4);
  vtkSMPropertyHelper(this, "MarksText").Set(session->GetMarksText());
  vtkSMPropertyHelper(this, "SourcesText").Set(session->GetSourcesText());
  vtkSMPropertyHelper(this, "Offset").Set(session->GetOffset(), 3);
  vtkSMPropertyHelper(this, "ReplayFile").Set(session->GetReplayFile());
  vtkSMPropertyHelper(this, "Precision").Set(session->GetPrecision() ? 1 : 0);
  vtkSMPropertyHelper(this, "Clutch").Set(session->GetClutch() ? 1 : 0);
  vtkSMPropertyHelper(this, "Recording").Set(session->GetRecording() ? 1 : 0);
  this->UpdateVTKObjects();
}
