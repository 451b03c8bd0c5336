// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticToolSource.h"

#include "vtkHapticNamedData.h"
#include "vtkHapticSession.h"
#include "vtkHapticViewScan.h"
#include "vtkSMProxy.h"

#include <utility>

void vtkHapticToolSource::Follow(vtkHapticSession& session, vtkSMProxy* view)
{
  const char* const name = session.GetSettingText("ToolSource");
  vtkDataObject* const data = *name != '\0' ? vtkHapticNamedData(view, name) : nullptr;
  const vtkMTimeType time = data ? data->GetMTime() : 0;
  if (!std::exchange(this->Known, true) || data != this->Data || time != this->Time)
  {
    this->Data = data;
    this->Time = time;
    session.AddTool(name, data);
  }
}

void vtkHapticToolSource::LeaveOut(vtkHapticSession* session, vtkHapticViewScan& scan)
{
  scan.LeaveOut(session ? session->GetSettingText("ToolSource") : "");
}
