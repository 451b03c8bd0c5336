// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces that move or bend: from where to where, how long, how late, and when they have come to rest.
#include <algorithm>
#include <utility>

#include "haptics/core/Clock.h"
#include "haptics/geometry/scene/SceneMotion.h"
#include "vtkHapticSessionInternals.h"

namespace
{
/// A longer time between two snapshots was a rest, not a motion.
constexpr double longestMotion_s = 0.2;

constexpr double rest_s = 1.0;
} // namespace

double vtkHapticSession::Internals::Now()
{
  return this->VirtualTimeNow() ? PeriodSeconds * static_cast<double>(this->Core.state().tick)
                                : 1e-9 * static_cast<double>(palpate::MonotonicClock().now_ns());
}

void vtkHapticSession::Internals::TakeScene(std::optional<vtkHapticBuiltScene> built)
{
  if (!built)
  {
    return;
  }
  if (this->Core.running() && this->Built.Scene)
  {
    const palpate::HapticState& felt = this->Core.state();
    const palpate::Scene& now = *this->Full.Scene; // what moves is felt with all its triangles
    const double share = felt.sceneRevision == now.revision() ? now.shareAt(felt.sceneAge_s) : 0.0;
    const double motion_s = std::clamp(built->Stamp - this->Built.Stamp, PeriodSeconds, longestMotion_s);
    built->Scene = palpate::movingFrom(now, share, built->Scene, motion_s);
  }
  this->Built = std::move(*built);
  this->HandOver = std::max(0.0, this->Now() - this->Built.Stamp);
  this->Core.setScene(this->Built.Scene);
  this->Full = this->Built;
  this->Worker.Follow(this->Core.running() ? this->Full.Scene : nullptr);
  this->PlanScene();
  this->FollowPlane();
}

void vtkHapticSession::Internals::SettleScene()
{
  const bool posed = this->Core.running() && this->Built.Scene && this->Built.Scene->moves();
  if (posed && this->State.sceneRevision == this->Built.Scene->revision() &&
      this->State.sceneAge_s > this->Built.Scene->motion_s() + rest_s)
  {
    this->Worker.Settle();
  }
}

bool vtkHapticSession::SetSurfacePose(const char* name, vtkMatrix4x4* matrix)
{
  const std::string known = name ? name : "surface";
  const std::string problem = this->Impl->Worker.Place(known, matrix);
  this->Refuse(problem);
  this->Impl->Follow(Internals::OfSurface + known, problem);
  return problem.empty();
}

double vtkHapticSession::GetMotionLag() const
{
  const double lag_s = this->Impl->State.motionLag_s;
  return this->GetTouching() && lag_s > 0.0 ? lag_s + this->Impl->HandOver : 0.0;
}

bool vtkHapticSession::GetSceneMoves() const
{
  return this->Impl->Built.Scene && this->Impl->Built.Scene->moves();
}
