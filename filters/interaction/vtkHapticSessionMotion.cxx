// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces that move or bend: where they are put, and how late that is felt.
#include "haptics/core/Clock.h"
#include "vtkHapticSessionInternals.h"

double vtkHapticSession::Internals::Now()
{
  return this->VirtualTimeNow() ? PeriodSeconds * static_cast<double>(this->Core.state().tick)
                                : 1e-9 * static_cast<double>(palpate::MonotonicClock().now_ns());
}

bool vtkHapticSession::SetSurfacePose(const char* name, vtkMatrix4x4* matrix)
{
  const std::string known = name ? name : "surface";
  const std::string problem = this->Impl->Surfaces.Place(known, matrix);
  this->Refuse(problem);
  this->Impl->Follow(Internals::OfSurface + known, problem);
  return problem.empty();
}

double vtkHapticSession::GetMotionLag() const
{
  const double lag_s = this->Impl->State.motionLag_s;
  return this->GetTouching() && lag_s > 0.0 ? lag_s + this->Impl->Scene.handOver_s() : 0.0;
}

bool vtkHapticSession::GetSceneMoves() const
{
  const std::shared_ptr<const palpate::Scene>& scene = this->Impl->Scene.built().scene;
  return scene && scene->moves();
}
