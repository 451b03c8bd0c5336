// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticRemoteSurface.h"

#include "vtkHapticServerProxies.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"

vtkHapticRemoteSurface::vtkHapticRemoteSurface(vtkSMSourceProxy* source, unsigned int port)
  : Watch(source), Port(port), Surface(vtkHapticMakeProxy(source, "filters", "GeometryFilter"))
{
  if (!this->Surface)
  {
    return;
  }
  vtkSMPropertyHelper(this->Surface, "Input").Set(source, port);
  vtkSMPropertyHelper(this->Surface, "PassThroughIds").Set(0);
  vtkSMPropertyHelper(this->Surface, "PassThroughPointIds").Set(0);
  this->Surface->UpdateVTKObjects();
  this->Cut = vtkHapticMakeProxy(source, "internal_filters", "HapticNeighbourhood");
  if (this->Cut)
  {
    vtkSMPropertyHelper(this->Cut, "Input").Set(this->Surface);
  }
}

bool vtkHapticRemoteSurface::IsStale(const vtkHapticPartWish& wish) const
{
  return this->Watch.HasChanged() || wish.Limit != this->Asked.Limit || wish.Time != this->Asked.Time;
}

vtkSmartPointer<vtkPolyData> vtkHapticRemoteSurface::Fetch(const vtkHapticPartWish& wish)
{
  if (!this->Cut)
  {
    return nullptr;
  }
  vtkSMPropertyHelper(this->Cut, "Centre").Set(wish.Centre.data(), 3);
  vtkSMPropertyHelper(this->Cut, "Reach").Set(wish.Reach);
  vtkSMPropertyHelper(this->Cut, "Limit").Set(wish.Limit);
  vtkSMPropertyHelper(this->Cut, "Number").Set(++this->Number);
  this->Cut->UpdateVTKObjects();
  return vtkPolyData::SafeDownCast(vtkHapticBring(this->Cut, VTK_POLY_DATA, wish.Time));
}

void vtkHapticRemoteSurface::Ask(const vtkHapticPartWish& wish)
{
  this->Changes += this->Watch.HasChanged() || wish.Time != this->Asked.Time ? 1 : 0;
  this->Watch.Forget();
  this->Asked = wish;
  const vtkSmartPointer<vtkPolyData> came = this->Fetch(wish);
  const std::optional<vtkHapticPartInfo> info = vtkHapticPartOf(came);
  this->Info = info.value_or(vtkHapticPartInfo());
  this->Problem = vtkHapticOtherVersion(this->Info.Version);
  this->Data = this->Problem.empty() ? came : nullptr;
}
