// SPDX-License-Identifier: GPL-3.0-or-later
// How the workspace of a device follows the hand that holds it and the view that is looked at.
#include <algorithm>

#include "vtkCommand.h"
#include "vtkHapticRecordings.h"
#include "vtkHapticSessionInternals.h"

using palpate::Vec3;

namespace
{
bool IsDown(int button, std::uint32_t buttons)
{
  return button > 0 && (buttons >> (button - 1) & 1u) != 0;
}

} // namespace

bool vtkHapticSession::Internals::LedInScene()
{
  return dynamic_cast<palpate::FedDevice*>(this->Core.device()) != nullptr;
}

std::optional<palpate::Quat> vtkHapticSession::Internals::ViewRotation(const palpate::DeviceInfo& device) const
{
  const bool inPlane = this->Scene.built().plane_WP && device.abilities.sensedAxes == 2;
  return inPlane ? std::nullopt : this->View_WD;
}

std::optional<palpate::CameAround> vtkHapticSession::Internals::PutInto(const palpate::WorkspaceMap& map)
{
  const auto& scene = this->Core.scene();
  const palpate::HapticState& felt = this->Core.state();
  const Vec3 put_W = map.toScene(felt.handle_D);
  if (this->LedInScene() || !scene || felt.tick == 0 || felt.held || palpate::isNearby(map, felt.device_W.p, put_W))
  {
    return std::nullopt;
  }
  return palpate::movedInto(*scene, this->Core.parameters().contact, felt.proxy_W.p, put_W);
}

void vtkHapticSession::Internals::AlignOnTouch(palpate::HapticDevice& device)
{
  const std::optional<palpate::Quat> q_WD = this->ViewRotation(device.info());
  const bool inScene = dynamic_cast<palpate::FedDevice*>(&device) != nullptr;
  if (this->Settings.whole("ViewAlignment") != AlignNever && q_WD && !inScene)
  {
    palpate::HandMapChange aligned{ this->Asked.asked().map, false };
    aligned.map.q_WD = *q_WD; // about the middle of the workspace: the hand's place is not known yet
    this->TakeMap(aligned);
    this->Session.InvokeEvent(vtkCommand::PropertyModifiedEvent);
  }
}

void vtkHapticSession::AlignWithView()
{
  Internals& impl = *this->Impl;
  const std::optional<palpate::Quat> q_WD = impl.ViewRotation(impl.InfoNow());
  if (q_WD && !impl.LedInScene())
  {
    palpate::WorkspaceMap map = impl.Asked.asked().map;
    map.q_WD = *q_WD;
    const bool known = this->GetTouching() && impl.State.tick > 0;
    this->Impl->TakeMap(
      { known ? keepingHand(map, { impl.State.handle_D, impl.State.device_W.p }) : map, impl.Asked.asked().clutch });
    this->InvokeEvent(vtkCommand::PropertyModifiedEvent);
  }
}

void vtkHapticSession::Internals::TakeMap(const palpate::HandMapChange& change)
{
  const bool fits = palpate::isSame(this->Asked.asked().map, this->LastFitted);
  this->LastFitted = fits ? change.map : this->LastFitted; // it was not set by hand
  this->Change(
    [&change](palpate::HapticParameters& p)
    {
      p.map = change.map;
      p.clutch = change.clutch;
    });
}

void vtkHapticSession::Internals::FollowHand()
{
  const palpate::HapticState& state = this->Core.state(); // the newest: a hand goes on moving
  if (!this->Core.running() || this->Recorded.Played || state.tick == 0 || state.held)
  {
    return;
  }
  if (this->LedInScene())
  {
    this->FollowMouseClutch();
    return;
  }
  palpate::HandWishes wishes;
  wishes.clutch = this->Settings.isOn("Clutch") || IsDown(this->Settings.whole("ClutchButton"), state.buttons);
  wishes.precise = this->Settings.isOn("Precision") || IsDown(this->Settings.whole("PrecisionButton"), state.buttons);
  wishes.precision = this->Settings.number("PrecisionFactor");
  wishes.q_WD =
    this->Settings.whole("ViewAlignment") == AlignAlways ? this->ViewRotation(this->InfoNow()) : std::nullopt;
  const auto change = this->HandMap.follow(wishes, this->Asked.asked().map, { state.handle_D, state.device_W.p });
  if (change)
  {
    const palpate::HapticParameters before = this->Asked.asked();
    const bool byHand = before.clutch || change->clutch || before.map.scale_u_per_m != change->map.scale_u_per_m;
    this->TakeMap(*change);
    if (byHand) // with every picture of a camera that turns is too often: see LetHandGo()
    {
      this->Session.InvokeEvent(vtkCommand::PropertyModifiedEvent);
    }
  }
}

/// A pointer is led in the scene, so no map holds its offset: vtkHapticMouse does, precision too.
void vtkHapticSession::Internals::FollowMouseClutch()
{
  const bool clutch = this->Settings.isOn("Clutch");
  if (this->Session.GetFollowsMouse() && clutch != this->Asked.asked().clutch)
  {
    this->TakeMap({ this->Asked.asked().map, clutch });
  }
}

void vtkHapticSession::Internals::LetHandGo()
{
  const bool held = this->HandMap.factor() != 1.0 || this->Asked.asked().clutch;
  if (held)
  {
    palpate::WorkspaceMap map = this->Asked.asked().map;
    map.scale_u_per_m *= this->HandMap.factor();
    const palpate::HandPlace hand{ this->State.handle_D, this->State.device_W.p };
    this->TakeMap({ this->LedInScene() ? map : keepingHand(map, hand), false });
  }
  this->HandMap.reset();
  if (held || this->Settings.isOn("Precision") || this->Settings.isOn("Clutch") ||
      this->Settings.whole("ViewAlignment") == AlignAlways)
  {
    this->LetButtonsGo();
    this->Session.InvokeEvent(vtkCommand::PropertyModifiedEvent);
  }
}
