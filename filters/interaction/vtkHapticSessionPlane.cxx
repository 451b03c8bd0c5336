// SPDX-License-Identifier: GPL-3.0-or-later
// Plane worlds: lines as walls, walls that the device holds, and the guide that leads a hand to their plane.
#include <utility>

#include "devices/common/DeviceNotes.h"
#include "vtkHapticSceneSurfaces.h"
#include "vtkHapticSessionInternals.h"

bool vtkHapticSession::Internals::RaisesLines() const
{
  return palpate::raisesLines(static_cast<palpate::AutoChoice>(this->Settings.whole("LinesAsWalls")), this->InfoNow());
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

std::string vtkHapticSession::Internals::PlaneText() const
{
  const palpate::DeviceInfo& info = this->InfoNow();
  const double drag_N = palpate::slantDrag_N(this->Asked.asked(), this->FeltStiffness(), PeriodSeconds);
  return this->Scene.built().plane_WP ? palpate::planeText(this->Asked.asked(), this->Asked.plane, info, drag_N,
                                          palpate::whyNotHeld(info.heldProof))
                                      : "";
}

bool vtkHapticSession::GetRaisesLines() const
{
  return this->Impl->RaisesLines();
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

std::string vtkHapticSession::Internals::FollowLinesAsWalls()
{
  this->FollowWalls();
  this->MaterialTime.Modified();
  return {};
}

std::string vtkHapticSession::Internals::FollowPlaneWishes()
{
  this->Asked.plane.holdWalls = this->Settings.isOn("HoldWalls");
  this->Asked.plane.guide = this->Settings.isOn("PlaneGuide");
  this->FollowPlane();
  return {};
}

std::string vtkHapticSession::Internals::FollowWallRate()
{
  this->Change([this](palpate::HapticParameters& p) { p.walls.every_s = 1.0 / this->Settings.number("WallRate"); });
  return {};
}
