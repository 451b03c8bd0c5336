// SPDX-License-Identifier: GPL-3.0-or-later
// The surfaces of the scene: put together, committed, and what came of them.
#include <algorithm>

#include "vtkHapticSessionInternals.h"

void vtkHapticSession::ClearSurfaces()
{
  this->Impl->Surfaces.Clear();
  if (this->Impl->ProblemOf.starts_with(Internals::OfSurface))
  {
    this->Impl->ProblemOf = Internals::OfFormerSurface;
  }
}

bool vtkHapticSession::AddSurface(const char* name, vtkDataObject* data, vtkMatrix4x4* matrix)
{
  const std::string known = name ? name : "surface";
  const std::string problem = this->Impl->Surfaces.Add(known, data, matrix);
  this->Refuse(problem);
  this->Impl->Follow(Internals::OfSurface + known, problem);
  return problem.empty();
}

void vtkHapticSession::CommitScene()
{
  this->Impl->Follow(Internals::OfFormerSurface, "");
  this->Impl->Scene.beforeCommit();
  this->Impl->Surfaces.Commit(this->Impl->Scene.worker(), this->Impl->Now());
}

bool vtkHapticSession::FinishScene()
{
  this->Impl->TakeScene(true);
  this->Impl->FollowRadius();
  return this->Impl->Scene.built().scene != nullptr;
}

bool vtkHapticSession::GetSceneBounds(double bounds[6]) const
{
  std::copy(this->Impl->Scene.built().bounds.begin(), this->Impl->Scene.built().bounds.end(), bounds);
  return this->Impl->Scene.built().scene != nullptr;
}

const char* vtkHapticSession::GetSceneReport() const
{
  return this->Impl->Scene.built().report.c_str();
}
