// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticNamedData.h"

#include "vtkAlgorithm.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"

vtkDataObject* vtkHapticNamedData(vtkSMProxy* any, const std::string& name)
{
  vtkSMSessionProxyManager* const manager = any ? any->GetSessionProxyManager() : nullptr;
  auto* const proxy = manager ? vtkSMSourceProxy::SafeDownCast(manager->GetProxy("sources", name.c_str())) : nullptr;
  if (!proxy)
  {
    return nullptr;
  }
  proxy->UpdatePipeline();
  auto* const source = vtkAlgorithm::SafeDownCast(proxy->GetClientSideObject());
  return source ? source->GetOutputDataObject(0) : nullptr;
}
