// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticMechanismSource.h"

#include "vtkHapticMechanism.h"
#include "vtkHapticNamedData.h"
#include "vtkHapticSession.h"
#include "vtkHapticViewScan.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSMProxy.h"

#include <algorithm>
#include <utility>

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

void vtkHapticMechanismSource::Follow(vtkHapticSession& session, vtkSMProxy* view)
{
  const std::string name = session.GetMechanismSource();
  if (this->Name != name)
  {
    Show(view, this->Name, nullptr);
  }
  vtkDataObject* const made = name.empty() ? nullptr : vtkHapticNamedData(view, name);
  vtkHapticMechanism* const maker = MakerOf(view, name);
  vtkDataObject* const atFirst = maker ? maker->GetAtFirst() : made;
  const std::string reason = maker ? maker->GetProblem() : "";
  const vtkMTimeType time = made && !maker ? made->GetMTime() : 0; // what a maker shows elsewhere is the same mechanism
  const bool others =
    atFirst != this->AtFirst || time != this->Time || reason != this->Reason || name != session.GetAddedMechanism();
  this->Name = name;
  if (!std::exchange(this->Known, true) || others)
  {
    this->AtFirst = atFirst;
    this->Time = time;
    this->Reason = reason;
    session.AddMechanism(name.c_str(), atFirst, reason.c_str());
  }
  vtkNew<vtkPolyData> moved;
  if (maker && maker->GetAtFirst())
  {
    moved->ShallowCopy(maker->GetAtFirst());
    const bool moves = session.MoveMechanism(moved);
    if (moves || this->Moves)
    {
      Show(view, name, moves ? moved.Get() : nullptr);
    }
    this->Moves = moves;
  }
}

void vtkHapticMechanismSource::LeaveOut(vtkHapticSession* session, vtkHapticViewScan& scan)
{
  const std::string name = session ? session->GetMechanismSource() : "";
  const auto isMoved = [&name](const vtkHapticViewScan::Source& source) { return source.Name == name && source.Moved; };
  if (session)
  {
    const bool moved = !name.empty() && std::any_of(scan.Sources.begin(), scan.Sources.end(), isMoved);
    session->SetMechanismMoved(moved);
  }
  scan.LeaveOut(name);
}
