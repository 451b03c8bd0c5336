// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces that move or bend: where they are put, and how late that is felt.
#include "haptics/core/Clock.h"
#include "vtkHapticSceneSurfaces.h"
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
  this->Impl->Refuse(problem);
  this->Impl->Follow(Internals::OfSurface + known, problem);
  return problem.empty();
}

bool vtkHapticSession::GetSceneMoves() const
{
  const std::shared_ptr<const palpate::Scene>& scene = this->Impl->Scene.built().scene;
  return scene && scene->moves();
}
