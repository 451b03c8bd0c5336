// SPDX-License-Identifier: GPL-3.0-or-later
// Plane worlds: lines as walls, walls that the device holds, and the guide that leads a hand to their plane.
#include <cmath>
#include <sstream>
#include <utility>

#include "devices/common/DeviceNotes.h"
#include "vtkHapticSessionInternals.h"

bool vtkHapticSession::Internals::RaisesLines() const
{
  return this->LinesAsWalls == On || (this->LinesAsWalls == Auto && this->InfoNow().abilities.sensedAxes == 2);
}

void vtkHapticSession::Internals::FollowWalls()
{
  this->Worker.SetPlaneWorld(this->RaisesLines(), this->Parameters.contact.radius_u);
  const bool before = std::exchange(this->Raises, this->RaisesLines());
  if (before || this->Raises)
  {
    this->MaterialTime.Modified(); // who follows a view adds its surfaces again
  }
}

void vtkHapticSession::Internals::FollowPlane()
{
  const bool planar = this->InfoNow().abilities.sensedAxes == 2;
  const std::optional<palpate::Pose>& plane_WP = this->Built.Plane_WP;
  palpate::HapticParameters wanted = this->Parameters;
  wanted.guide.on = plane_WP && this->PlaneGuide;
  if (plane_WP)
  {
    wanted.guide.point_W = plane_WP->p;
    wanted.guide.normal_W = (plane_WP->q * palpate::Vec3::UnitZ()).normalized();
  }
  wanted.guide.largest_N = planar ? 0.0 : palpate::GuidePlan().largest_N; // it has no motor that way
  constexpr double rounding = 1e-6;
  const palpate::Vec3 across_W = wanted.map.q_WD * palpate::Vec3::UnitZ();
  wanted.walls.hold = plane_WP && planar && this->HoldWalls && across_W.cross(wanted.guide.normal_W).norm() <= rounding;
  if (wanted.walls != this->Parameters.walls || wanted.guide != this->Parameters.guide)
  {
    palpate::HapticParameters sent = this->Parameters = wanted;
    sent.contact.radius_u = this->RadiusUsed_u;        // that follows the scene by itself
    static_cast<void>(this->Core.setParameters(sent)); // usable, for they come from a plane and the defaults
  }
}

double vtkHapticSession::Internals::SlantDrag_N() const
{
  palpate::Slide slide;
  slide.stiffness_N_per_m = this->FeltStiffness();
  slide.speed_m_per_s = 0.1;
  slide.depth_m = 1.0; // both walls press
  slide.host_s = this->Parameters.walls.every_s;
  slide.device_s = PeriodSeconds;
  slide.lean = std::sqrt(0.5);
  return palpate::velvet(slide).mean_N;
}

std::string vtkHapticSession::Internals::PlaneSentence() const
{
  if (!this->Built.Plane_WP)
  {
    return "";
  }
  std::ostringstream text;
  text.precision(3);
  text << ", in one plane: ";
  const palpate::DeviceInfo& info = this->InfoNow();
  const bool can = info.closesWalls();
  if (this->Parameters.walls.hold && can)
  {
    text << "at most four walls are held by the device itself, moved on at " << this->WallRate
         << " Hz: a slide of 0.1 m/s along a slant is braked by " << this->SlantDrag_N() << " N";
  }
  else
  {
    text << "walls are closed by the program";
    if (!can && info.offersWalls)
    {
      text << ", for the device offers to hold them, but " << palpate::whyNotHeld(info.heldProof);
    }
    else
    {
      text << (!info.abilities.holdsWalls ? ", for the device holds none"
               : !can                     ? ", for the device has no viscosity, without which corridors shake"
               : !this->HoldWalls         ? ", as was asked for"
                                          : ", for the plane does not lie across the device");
    }
  }
  text << (this->Parameters.guide.on && this->Parameters.guide.largest_N > 0.0 ? "; the hand is led to the plane" : "");
  return text.str();
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
  if (on != this->Impl->HoldWalls)
  {
    this->Impl->HoldWalls = on;
    this->Impl->FollowPlane();
    this->Modified();
  }
}

bool vtkHapticSession::GetHoldWalls() const
{
  return this->Impl->HoldWalls;
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
  if (on != this->Impl->PlaneGuide)
  {
    this->Impl->PlaneGuide = on;
    this->Impl->FollowPlane();
    this->Modified();
  }
}

bool vtkHapticSession::GetPlaneGuide() const
{
  return this->Impl->PlaneGuide;
}

bool vtkHapticSession::GetPlaneWorld() const
{
  return this->Impl->Built.Plane_WP.has_value();
}

bool vtkHapticSession::GetPlane(double point_W[3], double normal_W[3]) const
{
  const std::optional<palpate::Pose>& plane_WP = this->Impl->Built.Plane_WP;
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
