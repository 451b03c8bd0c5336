// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticLooseSources.h"

#include "vtkActor.h"
#include "vtkGeometryRepresentation.h"
#include "vtkHapticLengthUnit.h"
#include "vtkHapticNamedData.h"
#include "vtkHapticSession.h"
#include "vtkHapticSight.h"
#include "vtkHapticViewScan.h"
#include "vtkNew.h"
#include "vtkPVLODActor.h"
#include "vtkSMProxy.h"

#include <algorithm>

namespace
{
/// Null: it shows no surface.
vtkProp3D* PropOf(vtkSMProxy* representation)
{
  auto* const shown = vtkGeometryRepresentation::SafeDownCast(vtkHapticActiveRepresentation(representation));
  return shown ? shown->GetActor() : nullptr;
}

/// Where a display is by its properties, to the last bit as the prop itself would have it.
void MatrixBeside(vtkProp3D& prop, vtkMatrix4x4* own, vtkMatrix4x4& matrix)
{
  vtkNew<vtkActor> same;
  same->SetOrigin(prop.GetOrigin());
  same->SetPosition(prop.GetPosition());
  same->SetScale(prop.GetScale());
  same->SetOrientation(prop.GetOrientation());
  same->SetUserMatrix(own);
  matrix.DeepCopy(same->GetMatrix());
}
} // namespace

vtkHapticLooseSources::Moved& vtkHapticLooseSources::MovedOf(const std::string& name, vtkProp3D* prop)
{
  const auto found = std::find_if(
    this->Displays.begin(), this->Displays.end(), [prop](const Moved& moved) { return moved.Prop == prop; });
  if (found != this->Displays.end())
  {
    return *found;
  }
  vtkSmartPointer<vtkMatrix4x4> own;
  if (vtkMatrix4x4* const before = prop->GetUserMatrix())
  {
    own = vtkSmartPointer<vtkMatrix4x4>::New();
    own->DeepCopy(before);
  }
  return this->Displays.emplace_back(Moved{ name, prop, own });
}

/// Looking at all sources costs much.
void vtkHapticLooseSources::TellUnit(vtkHapticSession& session, vtkSMProxy* view)
{
  std::pair now{ session.GetSight()->GetMaterialTime(), vtkHapticVisibleRepresentations(view) };
  if (now != this->Looked)
  {
    this->Looked = std::move(now);
    session.GetSight()->SetUnitOfFiles(vtkHapticLengthUnitOf(view).Unit.c_str());
  }
}

void vtkHapticLooseSources::Follow(vtkHapticSession& session, vtkSMProxy* view)
{
  std::vector<vtkProp3D*> moved;
  vtkNew<vtkMatrix4x4> way;
  session.GetSight()->LookForLoose(
    [view](const std::string& name) { return !view || vtkHapticNamedProxy(view, name); });
  const bool any = view && session.GetSight()->GetHasLoose();
  if (any)
  {
    this->TellUnit(session, view);
  }
  for (vtkSMProxy* const shown : any ? vtkHapticVisibleRepresentations(view) : std::vector<vtkSMProxy*>())
  {
    const std::string name = vtkHapticNameOf(vtkHapticInputOf(shown));
    vtkProp3D* const prop = PropOf(shown);
    if (prop && session.GetSight()->GetLooseWay(name.c_str(), way))
    {
      const Moved& display = this->MovedOf(name, prop);
      vtkNew<vtkMatrix4x4> to;
      to->DeepCopy(way);
      if (display.Own)
      {
        vtkMatrix4x4::Multiply4x4(way, display.Own, to);
      }
      prop->SetUserMatrix(to);
      moved.push_back(prop);
    }
  }
  std::erase_if(this->Displays,
    [&moved](const Moved& display)
    {
      const bool stays = std::find(moved.begin(), moved.end(), display.Prop.Get()) != moved.end();
      if (!stays && display.Prop)
      {
        display.Prop->SetUserMatrix(display.Own);
      }
      return !stays;
    });
}

void vtkHapticLooseSources::Change(vtkHapticSession*, vtkSMProxy*, vtkHapticViewScan& scan)
{
  for (vtkHapticViewScan::Surface& surface : scan.Surfaces)
  {
    const auto moved = std::find_if(this->Displays.begin(), this->Displays.end(),
      [&surface](const Moved& display) { return display.Prop && display.Name == surface.Name; });
    if (moved != this->Displays.end())
    {
      MatrixBeside(*moved->Prop, moved->Own, *surface.Matrix);
    }
  }
}
