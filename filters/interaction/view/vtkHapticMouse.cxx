// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticMouse.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "haptics/session/settings/SessionSettings.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkHapticMouseInternals.h"
#include "vtkHapticSight.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkHapticMouse);

using palpate::Vec3;
using Ray = vtkHapticRay;

namespace
{
/// Of the scene's diagonal: presses and hovers no further, whatever the scale.
constexpr double largestShare = 0.05;
/// A notch of the wheel advances so far [m of the hand].
constexpr double notch_m = 0.002;

/// A file with a vertex that is not finite has such bounds, and is drawn.
void AddFinite(const double bounds[6], vtkBoundingBox& box)
{
  if (std::all_of(bounds, bounds + 6, [](double b) { return std::isfinite(b); }))
  {
    box.AddBounds(bounds);
  }
}
} // namespace

// Lengths and places
// -------------------------------------------------------------------------------------------------

/// A length of the hand in the scene [u], never much of it.
double vtkHapticMouse::Internals::Reach(double length_m) const
{
  const double length = length_m * this->Session->GetSetting("Scale");
  double b[6];
  return this->Session->GetSceneBounds(b)
           ? std::min(length, largestShare * std::hypot(b[1] - b[0], b[3] - b[2], b[5] - b[4]))
           : length;
}

/// Without a pointer in the view, through its middle.
Ray vtkHapticMouse::Internals::RayOfPointer() const
{
  const double* middle = this->Rays.Renderer->GetCenter();
  return this->Inside || this->Steered ? this->Rays.At(this->Led.x(), this->Led.y())
                                       : this->Rays.At(middle[0], middle[1]);
}

/// Whether a plane world is touched; if so, where the ray meets its plane, or the proxy where it does not. Walls across
/// a plane have no front to hover before.
bool vtkHapticMouse::Internals::MeetsPlane(const Ray& ray, Vec3& hand_W) const
{
  Vec3 point_W;
  Vec3 normal_W;
  if (!this->Session->GetPlane(point_W.data(), normal_W.data()))
  {
    return false;
  }
  constexpr double edgeOn = 1e-3; // the plane is seen as a line
  const double facing = ray.Along().dot(normal_W);
  const double distance = (point_W - ray.Near).dot(normal_W) / facing;
  const bool meets = std::abs(facing) > edgeOn && distance > 0.0;
  hand_W = meets ? Vec3(ray.Near + distance * ray.Along()) : Vec3(this->Session->GetProxyPosition());
  return true;
}

/// In front of all that is shown and all that is touched.
Vec3 vtkHapticMouse::Internals::Lifted(const Ray& ray) const
{
  vtkBoundingBox box;
  double b[6];
  this->Rays.Renderer->ComputeVisiblePropBounds(b);
  AddFinite(b, box);
  if (this->Session->GetSceneBounds(b))
  {
    AddFinite(b, box);
  }
  double depth =
    box.IsValid() ? std::numeric_limits<double>::infinity() : this->Rays.Renderer->GetActiveCamera()->GetDistance();
  for (int corner = 0; box.IsValid() && corner < 8; ++corner)
  {
    Vec3 p_W;
    box.GetCorner(corner, p_W.data());
    depth = std::min(depth, this->Rays.DepthOf(p_W));
  }
  const Vec3 towardsEye = -ray.Along();
  const double room = this->Reach(vtkHapticHover_m) + this->Session->GetSight()->GetToolReach(towardsEye.data());
  return this->Rays.AtDepth(ray, std::max(depth - room, this->Rays.DepthOf(ray.Near)));
}

// The pointer
// -------------------------------------------------------------------------------------------------------------

/// The hand's share of a pointer's displacement. A hand that hovers is where one points, precise or not: it came from
/// another widget, and would never get far from the edge of the view.
double vtkHapticMouse::Internals::ShareOfWay() const
{
  const bool feels = this->Pressing || this->Session->GetPlaneWorld() || this->AdvancesHeld();
  const double precise =
    this->Session->IsOn("Precision") && feels ? 1.0 / this->Session->GetSetting("PrecisionFactor") : 1.0;
  return this->Session->IsOn("Clutch") ? 0.0 : precise;
}

void vtkHapticMouse::Internals::PointAt(const vtkHapticPixels& pointer)
{
  const bool goesOn = this->Inside && this->Session;
  const bool keeps =
    !this->Inside && this->AdvancesHeld() && this->Depth.GetAlong() > 0.0; // a hand inside of the data stays there
  this->Led = goesOn  ? vtkHapticPixels(this->Led + this->ShareOfWay() * (pointer - this->Pointer))
              : keeps ? this->Led
                      : pointer;
  this->Pointer = pointer;
  this->Inside = true;
}

// The hand
// -------------------------------------------------------------------------------------------------------------

vtkHapticAim vtkHapticMouse::Internals::AimAt(const Ray& ray) const
{
  Vec3 ball_W;
  Vec3 n_W;
  if (!this->Session->GetSight()->PickSurface(ray.Near.data(), ray.Far.data(), ball_W.data(), n_W.data()))
  {
    const Vec3 inPlane_W = this->Rays.AtDepth(ray, this->Rays.DepthOf(this->Now.Proxy));
    return { inPlane_W, inPlane_W };
  }
  ball_W += this->Session->GetSight()->GetToolReach(n_W.data()) * n_W;
  const double clearance = std::min(this->Reach(vtkHapticHover_m), (ball_W - ray.Near).norm());
  return { ball_W - clearance * ray.Along(), ball_W - this->Reach(this->Session->GetSetting("PressDepth")) * n_W };
}

bool vtkHapticMouse::Internals::IsFree(const Vec3& to_W) const
{
  Vec3 ball_W;
  Vec3 n_W;
  return !this->Session->GetSight()->PickSurface(this->Hover_W.data(), to_W.data(), ball_W.data(), n_W.data());
}

/// Near enough to turn: the hand is always a little behind.
bool vtkHapticMouse::Internals::IsAt(const Vec3& p_W) const
{
  return (this->Now.Hand - p_W).norm() <= this->Reach(vtkHapticHover_m);
}

Vec3 vtkHapticMouse::Internals::Next(const Ray& ray)
{
  if (Vec3 hand_W; this->MeetsPlane(ray, hand_W))
  {
    return this->Hover_W = this->Inside ? hand_W : Vec3(this->Session->GetProxyPosition());
  }
  if (this->Advances(ray))
  {
    return this->NextAdvanced(ray);
  }
  this->TurnToSurface(ray);
  const vtkHapticAim aim = this->AimAt(ray);
  if (!this->Inside || (this->Way == Travel::Strokes && !this->IsFree(aim.Hover)))
  {
    this->Way = Travel::Rises;
  }
  if (this->Way == Travel::Rises)
  {
    const Vec3 up_W = this->Lifted(this->Rays.Through(this->Hover_W));
    this->Way = this->Inside && this->IsAt(up_W) ? Travel::Crosses : Travel::Rises;
    return up_W;
  }
  if (this->Way == Travel::Crosses)
  {
    this->Hover_W = this->Lifted(ray);
    this->Way = this->IsAt(this->Hover_W) ? Travel::Strokes : Travel::Crosses;
    return this->Hover_W;
  }
  this->Hover_W = aim.Hover;
  const bool felt = this->Session->GetEngageState() == vtkHapticSession::Engaged;
  return this->Pressing && felt ? aim.Press : aim.Hover;
}

void vtkHapticMouse::Internals::LeadTo(const Vec3& tip_W) const
{
  const Vec3 hand_W = tip_W - this->Tip_W;
  if (hand_W.allFinite()) // a camera that was reset to data that are not has no place for the hand
  {
    this->Session->SetHandPosition(hand_W.data());
  }
}

/// A hand that began inside of something could never leave it.
void vtkHapticMouse::Internals::PlaceBeforeStart()
{
  if (this->Session->GetFollowsMouse() && this->Sees())
  {
    const Ray ray = this->RayOfPointer();
    this->FollowHeld();
    this->Depth.Forget();
    if (this->AdvancesHeld())
    {
      this->PlaceDepth();
      this->Hover_W = this->Depth.Middle();
    }
    else if (!this->MeetsPlane(ray, this->Hover_W))
    {
      this->Hover_W = this->Lifted(ray);
    }
    this->Way = Travel::Rises;
    this->LeadTo(this->Hover_W);
  }
}

// The object
// -----------------------------------------------------------------------------------------------------------

vtkHapticMouse::vtkHapticMouse() : Impl(std::make_unique<Internals>()) {}

vtkHapticMouse::~vtkHapticMouse()
{
  this->SetSession(nullptr);
}

void vtkHapticMouse::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Leads: " << this->GetLeads() << "\n";
  os << indent << "Pointer: " << this->Impl->Pointer.x() << " " << this->Impl->Pointer.y()
     << (this->Impl->Inside ? "" : ", gone") << "\n";
  os << indent << "Pressing: " << this->Impl->Pressing << "\n";
}

void vtkHapticMouse::SetRenderer(vtkRenderer* renderer)
{
  this->Leave();
  this->Impl->Rays.Renderer = renderer;
  this->Impl->Bar.SetRenderer(renderer);
}

void vtkHapticMouse::SetSession(vtkHapticSession* session)
{
  Internals& impl = *this->Impl;
  if (impl.Session)
  {
    impl.Session->RemoveObserver(impl.StartObserver);
  }
  impl.Session = session;
  if (session)
  {
    impl.StartObserver = session->AddObserver(vtkCommand::StartEvent, &impl, &Internals::PlaceBeforeStart);
  }
}

vtkHapticSession* vtkHapticMouse::GetSession() const
{
  return this->Impl->Session;
}

bool vtkHapticMouse::GetLeads() const
{
  const Internals& impl = *this->Impl;
  return impl.Sees() && impl.Session && impl.Session->GetTouching() && impl.Session->GetFollowsMouse();
}

void vtkHapticMouse::SetPointer(double x, double y)
{
  Internals& impl = *this->Impl;
  const bool inView = impl.Sees() && impl.Rays.Renderer->IsInViewport(static_cast<int>(x), static_cast<int>(y));
  if (!inView || impl.Bar.IsAt(x, y))
  {
    this->Leave();
    return;
  }
  impl.PointAt({ x, y });
}

void vtkHapticMouse::MovePointer(double dx, double dy)
{
  Internals& impl = *this->Impl;
  if (impl.Sees())
  {
    const double* middle = impl.Rays.Renderer->GetCenter();
    this->SetPointer(
      (impl.Inside ? impl.Pointer.x() : middle[0]) + dx, (impl.Inside ? impl.Pointer.y() : middle[1]) + dy);
  }
}

void vtkHapticMouse::Leave()
{
  this->Impl->Inside = false;
  this->Impl->Pressing = false;
  this->Impl->Steered = false;
}

void vtkHapticMouse::SetPressing(bool on)
{
  const bool stays = this->Impl->AdvancesHeld(); // a tip in something does not go across to the pointer
  this->Impl->Led = this->Impl->Pressing && !on && !stays ? this->Impl->Pointer : this->Impl->Led;
  this->Impl->Pressing = on;
}

bool vtkHapticMouse::GetPressing() const
{
  return this->Impl->Pressing;
}

void vtkHapticMouse::Deepen(double factor)
{
  vtkHapticSession* session = this->Impl->Session;
  if (session && factor > 0.0)
  {
    const palpate::Setting& depth = palpate::sessionSetting("PressDepth");
    session->SetSetting("PressDepth", std::clamp(session->GetSetting("PressDepth") * factor, depth.low, depth.high));
    this->InvokeEvent(vtkCommand::InteractionEvent);
  }
}

bool vtkHapticMouse::GetAdvances() const
{
  return this->GetLeads() && this->Impl->Advances(this->Impl->RayOfPointer());
}

void vtkHapticMouse::Advance(double notches)
{
  if (this->Impl->Session)
  {
    this->Impl->Depth.Advance(notches * this->Impl->Reach(notch_m));
  }
}

bool vtkHapticMouse::GrabDepth(double x, double y)
{
  const bool grabs = this->GetAdvances() && this->Impl->Bar.IsAt(x, y);
  this->Impl->Steered = grabs;
  if (grabs)
  {
    this->Impl->Pressing = false;
    this->DragDepth(y);
  }
  return grabs;
}

void vtkHapticMouse::DragDepth(double y)
{
  this->Impl->Depth.AdvanceTo(this->Impl->DepthAt(this->Impl->Bar.ShareAt(y)));
}

void vtkHapticMouse::DropDepth()
{
  this->Impl->Steered = false;
}

bool vtkHapticMouse::GetDragsDepth() const
{
  return this->Impl->Steered;
}

void vtkHapticMouse::Lift()
{
  this->Impl->Pressing = false;
  this->Impl->Way = Internals::Travel::Rises;
  this->Impl->Depth.Retract();
}

double vtkHapticMouse::GetUsedDepth() const
{
  return this->Impl->Session ? this->Impl->Reach(this->Impl->Session->GetSetting("PressDepth")) : 0.0;
}

bool vtkHapticMouse::GetRay(double near_W[3], double far_W[3]) const
{
  if (!this->Impl->Sees())
  {
    return false;
  }
  const Ray ray = this->Impl->RayOfPointer();
  Eigen::Map<Vec3>{ near_W } = ray.Near;
  Eigen::Map<Vec3>{ far_W } = ray.Far;
  return true;
}

void vtkHapticMouse::Update()
{
  this->Impl->ShowDepth(this->GetAdvances());
  if (this->GetLeads() && !this->Impl->Session->IsOn("Clutch"))
  {
    this->Impl->Session->GetSight()->SetEye(
      this->Impl->Rays.EyeOn(Vec3(this->Impl->Session->GetProxyPosition())).data());
    this->Impl->FollowHeld();
    this->Impl->LookAround();
    this->Impl->LeadTo(this->Impl->Next(this->Impl->RayOfPointer()));
  }
}
