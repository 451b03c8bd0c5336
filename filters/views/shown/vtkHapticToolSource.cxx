// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticToolSource.h"

#include "vtkHapticNamedData.h"
#include "vtkSMProxy.h"

void vtkHapticToolSource::Follow(vtkHapticSession& session, vtkSMProxy* view)
{
  const std::string name = this->NameIn(&session);
  vtkDataObject* const data = name.empty() ? nullptr : vtkHapticNamedData(view, name);
  if (this->AreOthers(name, data, data ? data->GetMTime() : 0))
  {
    session.AddTool(name.c_str(), data);
  }
}
