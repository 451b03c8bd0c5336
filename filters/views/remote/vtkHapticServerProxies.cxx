// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticServerProxies.h"

#include "vtkAlgorithm.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSession.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"

vtkSmartPointer<vtkSMSourceProxy> vtkHapticMakeProxy(vtkSMProxy* beside, const char* group, const char* name)
{
  return vtkSmartPointer<vtkSMSourceProxy>::Take(
    vtkSMSourceProxy::SafeDownCast(beside->GetSessionProxyManager()->NewProxy(group, name)));
}

vtkSmartPointer<vtkDataObject> vtkHapticBring(vtkSMSourceProxy* source, int type, double time)
{
  // One that has brought something has no input here that could change, and would not listen when the server sends.
  const auto mover = vtkHapticMakeProxy(source, "filters", "ClientServerMoveData");
  vtkSMPropertyHelper(mover, "Input").Set(source);
  vtkSMPropertyHelper(mover, "OutputDataType").Set(type);
  mover->UpdateVTKObjects();
  mover->UpdatePipeline(time);
  auto* const here = vtkAlgorithm::SafeDownCast(mover->GetClientSideObject());
  return here ? here->GetOutputDataObject(0) : nullptr;
}
