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
  this->Superclass::UpdateVTKObjects(); // the values that were read back meanwhile
  this->Telling = false;
}

void vtkSMHapticSessionProxy::ReadBack()
{
  auto* session = vtkHapticSession::SafeDownCast(this->GetClientSideObject());
  for (const char* name : { "LinesAsWalls", "Radius", "Scale", "Precision", "Clutch", "Recording" })
  {
    vtkSMPropertyHelper(this, name).Set(0, session->GetSetting(name));
  }
  for (const char* name : { "Rotation", "Offset" })
  {
    vtkSMPropertyHelper(this, name)
      .Set(session->GetSettingNumbers(name), static_cast<unsigned int>(session->GetSettingSize(name)));
  }
  for (const char* name : { "MarksText", "SourcesText", "ReplayFile" })
  {
    vtkSMPropertyHelper(this, name).Set(session->GetSettingText(name));
  }
  this->UpdateVTKObjects();
}
