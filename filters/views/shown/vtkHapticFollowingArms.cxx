// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticFollowingArms.h"

#include "vtkHapticArm.h"
#include "vtkHapticNamedData.h"
#include "vtkHapticSession.h"
#include "vtkHapticSight.h"
#include "vtkHapticViewScan.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMProxyIterator.h"

#include <string>

namespace
{
vtkHapticArm* ArmOf(vtkSMProxy* proxy)
{
  return proxy ? vtkHapticArm::SafeDownCast(proxy->GetClientSideObject()) : nullptr;
}

/// Calls visit(proxy) for the sources of the pipeline of a view.
template<class Visit>
void ForEachSource(vtkSMProxy* view, const Visit& visit)
{
  vtkNew<vtkSMProxyIterator> each;
  each->SetSession(view->GetSession());
  each->SetModeToOneGroup();
  for (each->Begin("sources"); !each->IsAtEnd(); each->Next())
  {
    visit(each->GetProxy());
  }
}

/// Whether a source is an arm that follows the hand, or is made of one.
bool FollowsHand(vtkSMProxy* source)
{
  if (vtkHapticArm* const arm = ArmOf(source))
  {
    return arm->GetFollowHand();
  }
  constexpr bool quiet = true; // readers have no input
  const vtkSMPropertyHelper inputs(source, "Input", quiet);
  for (unsigned int i = 0; i < inputs.GetNumberOfElements(); ++i)
  {
    vtkSMProxy* const input = inputs.GetAsProxy(i);
    if (input && FollowsHand(input))
    {
      return true;
    }
  }
  return false;
}
} // namespace

void vtkHapticFollowingArms::Follow(vtkHapticSession& session, vtkSMProxy* view)
{
  double hand_D[3];
  double turn_D[4];
  vtkNew<vtkMatrix4x4> toScene;
  const bool hasHand = session.GetSight()->GetDeviceHand(hand_D, turn_D, toScene);
  const auto show = [&](vtkSMProxy* proxy)
  {
    vtkHapticArm* const arm = ArmOf(proxy);
    const bool follows = arm && arm->GetFollowHand() && session.GetTouching();
    const bool changed = follows ? hasHand && arm->ShowHand(hand_D, turn_D, toScene) : arm && arm->ShowTyped();
    if (changed)
    {
      proxy->MarkModified(nullptr);
    }
  };
  if (view)
  {
    ForEachSource(view, show);
  }
}

void vtkHapticFollowingArms::Change(vtkHapticSession*, vtkSMProxy* view, vtkHapticViewScan& scan)
{
  const auto leaveOut = [&scan](vtkSMProxy* proxy)
  {
    if (!FollowsHand(proxy))
    {
      return;
    }
    const std::string name = vtkHapticNameOf(proxy);
    const auto isOf = [&name](const std::string& refusal) { return refusal.starts_with(name + ": "); };
    const auto before = scan.Surfaces.size();
    scan.LeaveOut(name);
    if (std::erase_if(scan.Refusals, isOf) > 0 || scan.Surfaces.size() < before)
    {
      scan.Refusals.push_back(
        name + ": the arm follows the hand and is not touched; switch Follow Hand off to touch it.");
    }
  };
  if (view)
  {
    ForEachSource(view, leaveOut);
  }
}
