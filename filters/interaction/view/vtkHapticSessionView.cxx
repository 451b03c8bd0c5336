// SPDX-License-Identifier: GPL-3.0-or-later
// How the workspace of a device follows the hand that holds it and the view that is looked at.
#include <algorithm>

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkHapticSessionInternals.h"
#include "vtkMatrix4x4.h"

using palpate::Vec3;

namespace
{
bool IsDown(int button, std::uint32_t buttons)
{
  return button > 0 && (buttons >> (button - 1) & 1u) != 0;
}

Vec3 RowOf(vtkMatrix4x4* matrix, int row)
{
  return { matrix->GetElement(row, 0), matrix->GetElement(row, 1), matrix->GetElement(row, 2) };
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

void vtkHapticSession::FollowCamera(vtkCamera* camera)
{
  vtkMatrix4x4* const view = camera ? camera->GetViewTransformMatrix() : nullptr;
  this->Impl->View_WD = view ? palpate::viewRotation(RowOf(view, 0), RowOf(view, 1)) : std::nullopt;
}

void vtkHapticSession::AlignOnTouch(palpate::HapticDevice& device)
{
  Internals& impl = *this->Impl;
  const std::optional<palpate::Quat> q_WD = impl.ViewRotation(device.info());
  const bool inScene = dynamic_cast<palpate::FedDevice*>(&device) != nullptr;
  if (impl.ViewAlignment != AlignNever && q_WD && !inScene)
  {
    palpate::HandMapChange aligned{ impl.Asked.asked().map, false };
    aligned.map.q_WD = *q_WD; // about the middle of the workspace: nobody knows yet where the hand is
    this->TakeMap(aligned);
    this->InvokeEvent(vtkCommand::PropertyModifiedEvent);
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
    this->TakeMap(
      { known ? keepingHand(map, { impl.State.handle_D, impl.State.device_W.p }) : map, impl.Asked.asked().clutch });
    this->InvokeEvent(vtkCommand::PropertyModifiedEvent);
  }
}

void vtkHapticSession::TakeMap(const palpate::HandMapChange& change)
{
  Internals& impl = *this->Impl;
  const bool fits = palpate::isSame(impl.Asked.asked().map, impl.LastFitted);
  impl.LastFitted = fits ? change.map : impl.LastFitted; // it was not set by hand
  this->Change(
    [&change](palpate::HapticParameters& p)
    {
      p.map = change.map;
      p.clutch = change.clutch;
    });
}

void vtkHapticSession::FollowHand()
{
  Internals& impl = *this->Impl;
  const palpate::HapticState& state = impl.Core.state(); // the newest: a hand goes on moving
  if (!this->GetTouching() || impl.Played || state.tick == 0 || state.held)
  {
    return;
  }
  if (impl.LedInScene())
  {
    this->FollowMouseClutch();
    return;
  }
  palpate::HandWishes wishes;
  wishes.clutch = impl.Clutch || IsDown(impl.ClutchButton, state.buttons);
  wishes.precise = impl.Precision || IsDown(impl.PrecisionButton, state.buttons);
  wishes.precision = impl.PrecisionFactor;
  wishes.q_WD = impl.ViewAlignment == AlignAlways ? impl.ViewRotation(impl.InfoNow()) : std::nullopt;
  const auto change = impl.HandMap.follow(wishes, impl.Asked.asked().map, { state.handle_D, state.device_W.p });
  if (change)
  {
    const palpate::HapticParameters before = impl.Asked.asked();
    const bool byHand = before.clutch || change->clutch || before.map.scale_u_per_m != change->map.scale_u_per_m;
    this->TakeMap(*change);
    if (byHand) // with every picture of a camera that turns is too often: see LetHandGo()
    {
      this->InvokeEvent(vtkCommand::PropertyModifiedEvent);
    }
  }
}

/// A pointer is led in the scene, so no map holds what it was moved by: vtkHapticMouse does, precision too.
void vtkHapticSession::FollowMouseClutch()
{
  const Internals& impl = *this->Impl;
  if (this->GetFollowsMouse() && impl.Clutch != impl.Asked.asked().clutch)
  {
    this->TakeMap({ impl.Asked.asked().map, impl.Clutch });
  }
}

void vtkHapticSession::LetHandGo()
{
  Internals& impl = *this->Impl;
  const bool held = impl.HandMap.factor() != 1.0 || impl.Asked.asked().clutch;
  if (held)
  {
    palpate::WorkspaceMap map = impl.Asked.asked().map;
    map.scale_u_per_m *= impl.HandMap.factor();
    const palpate::HandPlace hand{ impl.State.handle_D, impl.State.device_W.p };
    this->TakeMap({ impl.LedInScene() ? map : keepingHand(map, hand), false });
  }
  impl.HandMap.reset();
  if (held || impl.Precision || impl.Clutch || impl.ViewAlignment == AlignAlways)
  {
    impl.Precision = impl.Clutch = false;
    this->InvokeEvent(vtkCommand::PropertyModifiedEvent);
  }
}

void vtkHapticSession::GetWorkspaceCorners(double corners_W[24]) const
{
  const Internals& impl = *this->Impl;
  for (const Vec3& corner_W : palpate::workspaceCorners(impl.Asked.asked().map, impl.InfoNow().workspaceRadius_m.value))
  {
    corners_W = std::copy(corner_W.begin(), corner_W.end(), corners_W);
  }
}

// Settings ----------------------------------------------------------------------------------------------------------

void vtkHapticSession::SetViewAlignment(int alignment)
{
  if (this->Allows("ViewAlignment", { static_cast<double>(alignment) }))
  {
    this->Impl->ViewAlignment = alignment;
    this->Modified();
  }
}

int vtkHapticSession::GetViewAlignment() const
{
  return this->Impl->ViewAlignment;
}

void vtkHapticSession::SetPrecisionFactor(double factor)
{
  if (this->Allows("PrecisionFactor", { factor }))
  {
    this->Impl->PrecisionFactor = factor;
    this->Modified();
  }
}

double vtkHapticSession::GetPrecisionFactor() const
{
  return this->Impl->PrecisionFactor;
}

void vtkHapticSession::SetPrecisionButton(int button)
{
  if (this->Allows("PrecisionButton", { static_cast<double>(button) }))
  {
    this->Impl->PrecisionButton = button;
    this->Modified();
  }
}

int vtkHapticSession::GetPrecisionButton() const
{
  return this->Impl->PrecisionButton;
}

void vtkHapticSession::SetClutchButton(int button)
{
  if (this->Allows("ClutchButton", { static_cast<double>(button) }))
  {
    this->Impl->ClutchButton = button;
    this->Modified();
  }
}

int vtkHapticSession::GetClutchButton() const
{
  return this->Impl->ClutchButton;
}

void vtkHapticSession::SetPrecision(bool on)
{
  this->Impl->Precision = on;
  this->Modified();
}

bool vtkHapticSession::GetPrecision() const
{
  return this->Impl->Precision;
}

void vtkHapticSession::SetClutch(bool on)
{
  this->Impl->Clutch = on;
  this->Modified();
}

bool vtkHapticSession::GetClutch() const
{
  return this->Impl->Clutch;
}

void vtkHapticSession::SetShowWorkspace(bool on)
{
  this->Impl->ShowWorkspace = on;
  this->Modified();
}

bool vtkHapticSession::GetShowWorkspace() const
{
  return this->Impl->ShowWorkspace;
}
