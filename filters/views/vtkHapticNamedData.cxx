// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticNamedData.h"

#include "vtkAlgorithm.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"

vtkDataObject* vtkHapticNamedData(vtkSMProxy* view, const std::string& name)
{
  vtkSMSessionProxyManager* const manager = view ? view->GetSessionProxyManager() : nullptr;
  auto* const proxy = manager ? vtkSMSourceProxy::SafeDownCast(manager->GetProxy("sources", name.c_str())) : nullptr;
  if (!proxy)
  {
    return nullptr;
  }
  proxy->UpdatePipeline(vtkSMPropertyHelper(view, "ViewTime").GetAsDouble());
  auto* const source = vtkAlgorithm::SafeDownCast(proxy->GetClientSideObject());
  return source && source->GetNumberOfOutputPorts() > 0 ? source->GetOutputDataObject(0) : nullptr;
}
