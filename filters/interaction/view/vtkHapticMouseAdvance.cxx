// SPDX-License-Identifier: GPL-3.0-or-later
// How a pointer leads a hand that advances: a held body along its axis, or any hand in a field.
#include <algorithm>

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkHapticMouseInternals.h"
#include "vtkHapticSight.h"

using palpate::Vec3;

namespace
{
/// The hand goes so fast across the view, and along its axis while it presses, against nothing and against a resistance
/// [m/s of the hand]. With the last, the force of a spring of 500 N/m grows by 2.5 N/s.
constexpr double pace_m_per_s = 0.15;
constexpr double press_m_per_s = 0.05;
constexpr double pressOn_m_per_s = 0.005;
/// A frame that took longer moves the hand no further than this [s].
constexpr double longestFrame_s = 0.1;
} // namespace

vtkHapticMouse::Internals::AlongChoice vtkHapticMouse::Internals::Along() const
{
  return static_cast<AlongChoice>(static_cast<int>(this->Session->GetSetting("HoldAlong")));
}

/// A mechanism always does; a tool only where that is chosen.
bool vtkHapticMouse::Internals::AdvancesHeld() const
{
  Vec3 tip_W;
  Vec3 axis_W;
  return this->Session && this->Session->GetSight()->GetHeldAxis(tip_W.data(), axis_W.data()) &&
         (this->Session->GetSight()->GetHoldsMechanism() || this->Along() == AlongChoice::OwnAxis ||
           this->Along() == AlongChoice::View);
}

/// In a field too, but where a surface stands before the plane that the hand is in.
bool vtkHapticMouse::Internals::Advances(const vtkHapticRay& ray) const
{
  if (this->AdvancesHeld())
  {
    return true;
  }
  Vec3 ball_W;
  Vec3 n_W;
  return this->Session->GetSight()->GetFeelsField() &&
         !(this->Session->GetSight()->PickSurface(ray.Near.data(), ray.Far.data(), ball_W.data(), n_W.data()) &&
           this->Depth.IsPlaced() && this->Rays.DepthOf(ball_W) < this->Rays.DepthOf(this->Depth.Middle()));
}

/// The tip of the held body now, turned first if the view says so.
void vtkHapticMouse::Internals::FollowHeld()
{
  const auto sight = this->Session->GetSight();
  this->Now.Axis = Vec3(this->Rays.Renderer->GetActiveCamera()->GetDirectionOfProjection());
  this->Tip_W.setZero();
  const bool ofView = this->Along() == AlongChoice::View;
  if (ofView)
  {
    sight->TurnHeldAxis(this->Now.Axis.data());
  }
  Vec3 axis_W;
  if (!this->Session->GetPlaneWorld() && sight->GetHeldAxis(this->Tip_W.data(), axis_W.data()) && !ofView &&
      this->AdvancesHeld())
  {
    this->Now.Axis = axis_W;
  }
}

/// A tool that only hovers is turned to the surface under the pointer.
void vtkHapticMouse::Internals::TurnToSurface(const vtkHapticRay& ray)
{
  Vec3 ball_W;
  Vec3 n_W;
  const auto sight = this->Session->GetSight();
  if (this->Along() == AlongChoice::SurfaceNormal && !this->Pressing &&
      sight->PickSurface(ray.Near.data(), ray.Far.data(), ball_W.data(), n_W.data()))
  {
    const Vec3 into_W = -n_W;
    sight->TurnHeldAxis(into_W.data());
    this->FollowHeld();
  }
}

/// Reads the hand's state since the last frame.
void vtkHapticMouse::Internals::LookAround()
{
  const vtkTypeInt64 tick = this->Session->GetTicks();
  const double frame_s = std::clamp(1e-3 * static_cast<double>(tick - this->LastTick), 0.0, longestFrame_s);
  this->LastTick = tick;
  this->Now.Hand = Vec3(this->Session->GetHandPosition()) + this->Tip_W;
  this->Now.Proxy = Vec3(this->Session->GetProxyPosition()) + this->Tip_W;
  this->Now.Led = this->Hover_W;
  this->Now.Pace = this->Reach(frame_s * pace_m_per_s);
  this->Now.Press = this->Reach(frame_s * press_m_per_s);
  this->Now.PressOn = this->Reach(frame_s * pressOn_m_per_s);
  this->Now.Depth = this->Reach(this->Session->GetSetting("PressDepth"));
  this->Now.Firm = this->Reach(this->Session->GetSight()->GetLargestDepth());
  this->Now.Held = this->AdvancesHeld();
  this->Now.Pressing = this->Pressing && this->Session->GetEngageState() == vtkHapticSession::Engaged;
}

/// How far the held body reaches beyond its tip along its axis, to which it may still be turned [u].
double vtkHapticMouse::Internals::ReachOfHeld() const
{
  Vec3 tip_W;
  Vec3 axis_W;
  if (!this->Session->GetSight()->GetHeldAxis(tip_W.data(), axis_W.data()))
  {
    return 0.0;
  }
  const Vec3 back_W = -axis_W;
  return this->Session->GetSight()->GetToolReach(back_W.data());
}

/// In the middle of all that can be met; a body or tool in the hand begins before all of it.
void vtkHapticMouse::Internals::PlaceDepth()
{
  vtkBoundingBox met;
  double b[6];
  Vec3 middle_W = this->Hover_W;
  double before = 0.0;
  this->Span = 0.0;
  if (this->Session->GetSight()->GetMetBounds(b))
  {
    met.SetBounds(b);
    met.GetCenter(middle_W.data());
    Vec3 lengths;
    met.GetLengths(lengths.data());
    this->Span = lengths.dot(this->Now.Axis.cwiseAbs());
    before = 0.5 * this->Span + this->Reach(vtkHapticHover_m) + this->ReachOfHeld();
  }
  this->Depth.Place(middle_W - (this->AdvancesHeld() ? before : 0.0) * this->Now.Axis, this->Now.Axis);
}

/// A body or tool in the hand begins before all that can be met, a hand in a field in the middle.
double vtkHapticMouse::Internals::LeastAlong() const
{
  return this->AdvancesHeld() ? 0.0 : -0.5 * this->Span;
}

double vtkHapticMouse::Internals::DepthAt(double share) const
{
  return this->LeastAlong() + share * this->Span;
}

void vtkHapticMouse::Internals::ShowDepth(bool shown)
{
  const bool spans = shown && this->Depth.IsPlaced() && this->Span > 0.0;
  spans ? this->Bar.Show((this->Depth.GetAlong() - this->LeastAlong()) / this->Span) : this->Bar.Hide();
}

/// Walls of a field that is not felt yet would not hold the hand back.
bool vtkHapticMouse::Internals::MayGoTo(const Vec3& tip_W) const
{
  const auto sight = this->Session->GetSight();
  const bool felt = this->Session->GetEngageState() == vtkHapticSession::Engaged;
  return !sight->GetFeelsField() || (felt && sight->GetFieldIsReady(tip_W.data()));
}

Vec3 vtkHapticMouse::Internals::NextAdvanced(const vtkHapticRay& ray)
{
  if (!this->Depth.IsPlaced())
  {
    this->PlaceDepth();
  }
  this->Depth.FollowAxis(this->Now);
  if (this->Way == Travel::Rises && this->Depth.GetAlongOf(this->Now.Hand) <= this->Reach(vtkHapticHover_m))
  {
    this->Led = this->Pointer; // a hand that went back out may go across
    this->Way = Travel::Strokes;
  }
  const Vec3 aimed_W = this->Rays.AtDepth(ray, this->Rays.DepthOf(this->Depth.Middle()));
  const Vec3 next_W =
    this->Inside || this->Steered ? this->Depth.Next(aimed_W, this->Now) : this->Depth.Rest(this->Now);
  this->Hover_W = this->MayGoTo(next_W) ? next_W : this->Hover_W;
  return this->Hover_W;
}
