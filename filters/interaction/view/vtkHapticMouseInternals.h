// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticMouseInternals_h
#define vtkHapticMouseInternals_h

#include "haptics/core/Types.h"
#include "vtkHapticAdvance.h"
#include "vtkHapticDepthBar.h"
#include "vtkHapticMouse.h"
#include "vtkHapticSession.h"
#include "vtkHapticViewRays.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

/// Where the pointer has the tip of the hand be, in W [u].
struct vtkHapticAim
{
  palpate::Vec3 Hover;
  palpate::Vec3 Press;
};

/// On the screen, from the lower left corner of the window.
using vtkHapticPixels = Eigen::Vector2d;

/// The hand hovers so far in front of the surface under the pointer [m of the hand].
inline constexpr double vtkHapticHover_m = 0.005;

class vtkHapticMouse::Internals
{
public:
  /// In which direction a body or tool in the hand advances: the choices of HoldAlong.
  enum class AlongChoice
  {
    Automatic,
    OwnAxis,
    SurfaceNormal,
    View,
  };

  /// The hand strokes, or on its way to where it cannot go straight it rises and goes across in front of everything.
  enum class Travel
  {
    Strokes,
    Rises,
    Crosses,
  };

  vtkHapticViewRays Rays;
  vtkSmartPointer<vtkHapticSession> Session;
  unsigned long StartObserver = 0;
  vtkHapticPixels Pointer = vtkHapticPixels::Zero();
  vtkHapticPixels Led =
    vtkHapticPixels::Zero(); ///< the hand is under it: the pointer, less the motion that clutch and precision took away
  bool Inside = false;
  bool Pressing = false;
  bool Steered = false; ///< its depth, by the handle of the bar
  Travel Way = Travel::Rises;
  palpate::Vec3 Hover_W = palpate::Vec3::Zero(); ///< the last free place it was led to
  palpate::Vec3 Tip_W = palpate::Vec3::Zero();   ///< from the hand to the point that the pointer leads
  vtkHapticDepthBar Bar;
  double Span = 0.0;      ///< of all that can be met, along the axis [u]
  vtkHapticAdvance Depth; ///< while it advances
  vtkHapticAdvance::Frame Now{};
  vtkTypeInt64 LastTick = 0; ///< of the session, when the hand was led last

  bool Sees() const { return this->Rays.Renderer && this->Rays.Renderer->GetRenderWindow(); }
  vtkHapticRay RayOfPointer() const;
  double Reach(double length_m) const;
  double ShareOfWay() const;
  void PointAt(const vtkHapticPixels& pointer);
  bool MeetsPlane(const vtkHapticRay& ray, palpate::Vec3& hand_W) const;
  palpate::Vec3 Lifted(const vtkHapticRay& ray) const;
  vtkHapticAim AimAt(const vtkHapticRay& ray) const;
  bool IsFree(const palpate::Vec3& to_W) const;
  bool IsAt(const palpate::Vec3& p_W) const;
  AlongChoice Along() const;
  bool AdvancesHeld() const;
  bool Advances(const vtkHapticRay& ray) const;
  void FollowHeld();
  void TurnToSurface(const vtkHapticRay& ray);
  void LookAround();
  double ReachOfHeld() const;
  void PlaceDepth();
  double LeastAlong() const;
  double DepthAt(double share) const;
  void ShowDepth(bool shown);
  bool MayGoTo(const palpate::Vec3& tip_W) const;
  palpate::Vec3 Next(const vtkHapticRay& ray);
  palpate::Vec3 NextAdvanced(const vtkHapticRay& ray);
  void PlaceBeforeStart();
  void LeadTo(const palpate::Vec3& tip_W) const;
};

#endif
