// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticMechanismSource.h"

#include "vtkHapticMechanism.h"
#include "vtkHapticMechanismData.h"
#include "vtkHapticNamedData.h"
#include "vtkHapticServerProxies.h"
#include "vtkHapticTouchedMechanism.h"
#include "vtkNew.h"
#include "vtkPVDataInformation.h"
#include "vtkPolyData.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"

#include <algorithm>

namespace
{
/// The source that made a mechanism; null: none that can show where its bodies are.
vtkHapticMechanism* MakerOf(vtkSMProxy* view, const std::string& name)
{
  vtkSMProxy* const proxy = vtkHapticNamedProxy(view, name);
  return proxy ? vtkHapticMechanism::SafeDownCast(proxy->GetClientSideObject()) : nullptr;
}

void Show(vtkSMProxy* view, const std::string& name, vtkPolyData* moved)
{
  if (vtkHapticMechanism* const maker = MakerOf(view, name))
  {
    maker->ShowMoved(moved);
    vtkHapticNamedProxy(view, name)->MarkModified(nullptr);
  }
}
} // namespace

vtkDataObject* vtkHapticMechanismSource::Bring(vtkSMProxy* view, const std::string& name)
{
  auto* const source = vtkSMSourceProxy::SafeDownCast(vtkHapticNamedProxy(view, name));
  if (!source || source->GetClientSideObject())
  {
    this->Watch.reset();
    this->Brought = nullptr;
    return nullptr;
  }
  if (!this->Watch || this->Watch->GetSource() != source)
  {
    this->Watch = std::make_unique<vtkHapticSourceWatch>(source);
  }
  source->UpdatePipeline(); // at a time it would say each time that there are other data
  if (this->Watch->HasChanged())
  {
    this->Watch->Forget();
    this->Brought = vtkSmartPointer<vtkPolyData>::New(); // no mechanism
    if (source->GetDataInformation()->GetDataSetType() == VTK_POLY_DATA)
    {
      this->Brought = vtkHapticBring(source, VTK_POLY_DATA, vtkSMPropertyHelper(view, "ViewTime").GetAsDouble());
    }
    if (this->Brought)
    {
      vtkHapticSetOfServer(*this->Brought);
    }
  }
  return this->Brought;
}

void vtkHapticMechanismSource::Follow(vtkHapticSession& session, vtkSMProxy* view)
{
  const std::string name = this->NameIn(&session);
  if (this->Name != name)
  {
    Show(view, this->Name, nullptr);
  }
  vtkDataObject* const brought = this->Bring(view, name);
  vtkDataObject* const made = brought || name.empty() ? brought : vtkHapticNamedData(view, name);
  vtkHapticMechanism* const maker = MakerOf(view, name);
  vtkDataObject* const atFirst = maker ? maker->GetAtFirst() : made;
  const std::string reason = maker ? maker->GetProblem() : "";
  const vtkMTimeType time = made && !maker ? made->GetMTime() : 0; // bodies shown elsewhere are the same mechanism
  if (this->AreOthers(name, atFirst, time, reason) || name != session.GetMechanism()->GetAdded())
  {
    session.AddMechanism(name.c_str(), atFirst, reason.c_str());
  }
  vtkNew<vtkPolyData> moved;
  if (maker && maker->GetAtFirst())
  {
    moved->ShallowCopy(maker->GetAtFirst());
    const bool moves = session.GetMechanism()->Move(moved);
    if (moves || this->Moves)
    {
      Show(view, name, moves ? moved.Get() : nullptr);
    }
    this->Moves = moves;
  }
}

void vtkHapticMechanismSource::Change(vtkHapticSession* session, vtkSMProxy* view, vtkHapticViewScan& scan)
{
  const std::string name = this->NameIn(session);
  const auto isMoved = [&name](const vtkHapticViewScan::Source& source) { return source.Name == name && source.Moved; };
  if (session)
  {
    const bool moved = !name.empty() && std::any_of(scan.Sources.begin(), scan.Sources.end(), isMoved);
    session->GetMechanism()->SetMoved(moved);
  }
  this->vtkHapticHandedSource::Change(session, view, scan);
}
