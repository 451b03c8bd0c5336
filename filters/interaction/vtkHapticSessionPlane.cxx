// SPDX-License-Identifier: GPL-3.0-or-later
// Plane worlds: lines as walls, walls that the device holds, and the guide that leads a hand to their plane.
#include <utility>

#include "devices/common/DeviceNotes.h"
#include "vtkHapticSessionInternals.h"

bool vtkHapticSession::Internals::RaisesLines() const
{
  return palpate::raisesLines(static_cast<palpate::AutoChoice>(this->LinesAsWalls), this->InfoNow());
}

void vtkHapticSession::Internals::FollowWalls()
{
  this->Surfaces.SetPlaneWorld(this->RaisesLines(), this->Asked.asked().contact.radius_u);
  const bool before = std::exchange(this->Raises, this->RaisesLines());
  if (before || this->Raises)
  {
    this->MaterialTime.Modified(); // who follows a view adds its surfaces again
  }
}

void vtkHapticSession::Internals::FollowPlane()
{
  if (const auto told = this->Asked.otherPlane(this->Scene.built(), this->InfoNow()))
  {
    static_cast<void>(this->Core.setParameters(*told));
  }
}

std::string vtkHapticSession::Internals::PlaneSentence() const
{
  const palpate::DeviceInfo& info = this->InfoNow();
  const double drag_N = palpate::slantDrag_N(this->Asked.asked(), this->FeltStiffness(), PeriodSeconds);
  return this->Scene.built().plane_WP ? palpate::planeSentence(this->Asked.asked(), this->Asked.plane, info, drag_N,
                                          palpate::whyNotHeld(info.heldProof))
                                      : "";
}

void vtkHapticSession::SetLinesAsWalls(int choice)
{
  if (this->Allows("LinesAsWalls", { static_cast<double>(choice) }) && choice != this->Impl->LinesAsWalls)
  {
    this->Impl->LinesAsWalls = choice;
    this->Impl->FollowWalls();
    this->Impl->MaterialTime.Modified();
    this->Modified();
  }
}

int vtkHapticSession::GetLinesAsWalls() const
{
  return this->Impl->LinesAsWalls;
}

bool vtkHapticSession::GetRaisesLines() const
{
  return this->Impl->RaisesLines();
}

void vtkHapticSession::SetHoldWalls(bool on)
{
  if (on != this->Impl->Asked.plane.holdWalls)
  {
    this->Impl->Asked.plane.holdWalls = on;
    this->Impl->FollowPlane();
    this->Modified();
  }
}

bool vtkHapticSession::GetHoldWalls() const
{
  return this->Impl->Asked.plane.holdWalls;
}

void vtkHapticSession::SetWallRate(double rate_Hz)
{
  if (this->Allows("WallRate", { rate_Hz }))
  {
    this->Impl->WallRate = rate_Hz;
    this->Change([=](palpate::HapticParameters& p) { p.walls.every_s = 1.0 / rate_Hz; });
  }
}

double vtkHapticSession::GetWallRate() const
{
  return this->Impl->WallRate;
}

void vtkHapticSession::SetPlaneGuide(bool on)
{
  if (on != this->Impl->Asked.plane.guide)
  {
    this->Impl->Asked.plane.guide = on;
    this->Impl->FollowPlane();
    this->Modified();
  }
}

bool vtkHapticSession::GetPlaneGuide() const
{
  return this->Impl->Asked.plane.guide;
}

bool vtkHapticSession::GetPlaneWorld() const
{
  return this->Impl->Scene.built().plane_WP.has_value();
}

bool vtkHapticSession::GetPlane(double point_W[3], double normal_W[3]) const
{
  const std::optional<palpate::Pose>& plane_WP = this->Impl->Scene.built().plane_WP;
  if (plane_WP)
  {
    Eigen::Map<palpate::Vec3>{ point_W } = plane_WP->p;
    Eigen::Map<palpate::Vec3>{ normal_W } = (plane_WP->q * palpate::Vec3::UnitZ()).normalized();
  }
  return plane_WP.has_value();
}

int vtkHapticSession::GetWallsHeld() const
{
  return this->Impl->State.walls;
}

double vtkHapticSession::GetGuideShare() const
{
  return this->Impl->State.guideShare;
}
