// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticSoftSource.h"

#include "vtkHapticNamedData.h"
#include "vtkHapticSoftBody.h"
#include "vtkHapticSoftSkin.h"
#include "vtkNew.h"
#include "vtkSMProxy.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <iterator>

namespace
{
/// The filter that made a body; null: none that can show it bent.
vtkHapticSoftBody* FilterOf(vtkSMProxy* proxy)
{
  return proxy ? vtkHapticSoftBody::SafeDownCast(proxy->GetClientSideObject()) : nullptr;
}

/// A body at rest: the same object until another one is made.
vtkDataObject* BodyOf(vtkSMProxy* view, const std::string& name)
{
  vtkDataObject* const made = name.empty() ? nullptr : vtkHapticNamedData(view, name);
  vtkHapticSoftBody* const filter = FilterOf(vtkHapticNamedProxy(view, name));
  return filter ? filter->GetRest() : made;
}
} // namespace

void vtkHapticSoftSource::Follow(vtkHapticSession& session, vtkSMProxy* view)
{
  const std::string name = this->NameIn(&session);
  if (!this->Name.empty() && this->Name != name)
  {
    if (vtkHapticSoftBody* const before = FilterOf(vtkHapticNamedProxy(view, this->Name)))
    {
      before->ShowBent(nullptr);
      vtkHapticNamedProxy(view, this->Name)->MarkModified(nullptr);
    }
  }
  vtkDataObject* const body = BodyOf(view, name);
  if (this->AreOthers(name, body))
  {
    session.AddSoftBody(name.c_str(), body);
  }
  vtkHapticSoftBody* const filter = FilterOf(vtkHapticNamedProxy(view, name));
  vtkNew<vtkUnstructuredGrid> bent;
  if (filter && filter->GetRest())
  {
    bent->ShallowCopy(filter->GetRest());
    if (session.BendSoftBody(bent))
    {
      filter->ShowBent(bent);
      vtkHapticNamedProxy(view, name)->MarkModified(nullptr);
    }
  }
}

void vtkHapticSoftSource::Change(vtkHapticSession* session, vtkSMProxy* /*view*/, vtkHapticViewScan& scan)
{
  const std::string name = this->NameIn(session);
  const auto isIt = [&name](const auto& shown) { return shown.Name == name || vtkHapticSoftSkin::IsSkin(shown.Data); };
  const auto found = std::find_if(scan.Surfaces.begin(), scan.Surfaces.end(), isIt);
  if (name.empty() || found == scan.Surfaces.end())
  {
    return;
  }
  if (found->Matrix && !found->Matrix->IsIdentity())
  {
    scan.Refusals.push_back(name + ": the soft body is touched at the position of its data, not of its display; reset "
                                   "the display transform, or apply the filter Transform before Soft Body.");
  }
  if (!this->AtRest || this->AtRest->Name != name || this->AtRestOf != this->Data)
  {
    this->AtRestOf = this->Data;
    this->AtRest = *found;
    this->AtRest->Name = name;
    this->AtRest->Data = vtkSmartPointer<vtkDataObject>::Take(found->Data->NewInstance());
    this->AtRest->Data->ShallowCopy(found->Data); // the shown data are filled anew when the body bends
  }
  *found = *this->AtRest;
  scan.Surfaces.erase(std::remove_if(std::next(found), scan.Surfaces.end(), isIt), scan.Surfaces.end());
}
