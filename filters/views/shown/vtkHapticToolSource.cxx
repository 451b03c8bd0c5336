// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticToolSource.h"

#include "vtkAlgorithm.h"
#include "vtkHapticSession.h"
#include "vtkHapticViewScan.h"
#include "vtkSMProxy.h"
#include "vtkSMSessionProxyManager.h"

#include <algorithm>
#include <string>
#include <utility>

namespace
{
/// Null where there is none of that name, or it has made nothing yet.
vtkDataObject* OutputOf(vtkSMProxy* view, const char* name)
{
  vtkSMProxy* const source = view && *name ? view->GetSessionProxyManager()->GetProxy("sources", name) : nullptr;
  auto* const algorithm = vtkAlgorithm::SafeDownCast(source ? source->GetClientSideObject() : nullptr);
  return algorithm && algorithm->GetNumberOfOutputPorts() > 0 ? algorithm->GetOutputDataObject(0) : nullptr;
}
} // namespace

void vtkHapticToolSource::Follow(vtkHapticSession& session, vtkSMProxy* view)
{
  const char* const name = session.GetToolSource();
  vtkDataObject* const data = OutputOf(view, name);
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
  const std::string tool = session ? session->GetToolSource() : "";
  const auto isTool = [&tool](const auto& shown) { return shown.Name == tool; };
  scan.Surfaces.erase(std::remove_if(scan.Surfaces.begin(), scan.Surfaces.end(), isTool), scan.Surfaces.end());
}
