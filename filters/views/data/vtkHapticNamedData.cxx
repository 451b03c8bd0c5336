// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticNamedData.h"

#include "vtkAlgorithm.h"
#include "vtkPVCompositeRepresentation.h"
#include "vtkPVDataRepresentation.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSession.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"

namespace
{
/// By its display, whatever of it is drawn.
bool IsMoved(vtkSMProxy* representation)
{
  const auto differs = [representation](const char* property, double usual)
  {
    constexpr bool quiet = true; // not every display can be moved
    const vtkSMPropertyHelper values(representation, property, quiet);
    for (unsigned int i = 0; i < values.GetNumberOfElements(); ++i)
    {
      if (values.GetAsDouble(i) != usual)
      {
        return true;
      }
    }
    return false;
  };
  // ParaView 5.13 calls a display's position its translation.
  return differs("Position", 0.0) || differs("Translation", 0.0) || differs("Orientation", 0.0) ||
         differs("Scale", 1.0);
}

bool Visible(vtkSMProxy* representation)
{
  return representation->GetProperty("Visibility") && vtkSMPropertyHelper(representation, "Visibility").GetAsInt() != 0;
}
} // namespace

vtkObject* vtkHapticActiveRepresentation(vtkSMProxy* representation)
{
  auto* object = vtkObject::SafeDownCast(representation->GetClientSideObject());
  auto* composite = vtkPVCompositeRepresentation::SafeDownCast(object);
  return composite ? composite->GetActiveRepresentation() : object;
}

vtkSMProxy* vtkHapticInputOf(vtkSMProxy* representation)
{
  return representation->GetProperty("Input") ? vtkSMPropertyHelper(representation, "Input", true).GetAsProxy()
                                              : nullptr;
}

std::string vtkHapticNameOf(vtkSMProxy* source)
{
  const char* name = source ? source->GetSessionProxyManager()->GetProxyName("sources", source) : nullptr;
  return name ? name : "";
}

std::vector<vtkSMProxy*> vtkHapticVisibleRepresentations(vtkSMProxy* view)
{
  std::vector<vtkSMProxy*> visible;
  const vtkSMPropertyHelper all(view, "Representations");
  for (unsigned int i = 0; i < all.GetNumberOfElements(); ++i)
  {
    vtkSMProxy* const representation = all.GetAsProxy(i);
    if (representation && Visible(representation))
    {
      visible.push_back(representation);
    }
  }
  return visible;
}

bool vtkHapticIsRemote(vtkSMProxy* view)
{
  return view->GetSession() && view->GetSession()->IsA("vtkSMSessionClient");
}

vtkHapticViewScan::Source vtkHapticShownSource(vtkSMProxy* representation, const std::string& name)
{
  vtkSMPropertyHelper input(representation, "Input", true);
  auto* const proxy = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
  auto* const here = proxy ? vtkAlgorithm::SafeDownCast(proxy->GetClientSideObject()) : nullptr;
  const unsigned int port = proxy ? input.GetOutputPort() : 0;
  return { name, here ? here->GetOutputDataObject(static_cast<int>(port)) : nullptr, IsMoved(representation),
    here ? nullptr : proxy, port };
}

vtkSMProxy* vtkHapticNamedProxy(vtkSMProxy* view, const std::string& name)
{
  vtkSMSessionProxyManager* const manager = view && !name.empty() ? view->GetSessionProxyManager() : nullptr;
  return manager ? manager->GetProxy("sources", name.c_str()) : nullptr;
}

vtkHapticViewScan::Source vtkHapticNamedSource(vtkSMProxy* view, const std::string& name)
{
  auto* const proxy = vtkSMSourceProxy::SafeDownCast(vtkHapticNamedProxy(view, name));
  if (!proxy)
  {
    return { name };
  }
  proxy->UpdatePipeline(vtkSMPropertyHelper(view, "ViewTime").GetAsDouble());
  auto* const here = vtkAlgorithm::SafeDownCast(proxy->GetClientSideObject());
  const bool hasData = here && here->GetNumberOfOutputPorts() > 0;
  return { name, hasData ? here->GetOutputDataObject(0) : nullptr, false, here ? nullptr : proxy };
}

vtkDataObject* vtkHapticNamedData(vtkSMProxy* view, const std::string& name)
{
  return vtkHapticNamedSource(view, name).Data;
}
