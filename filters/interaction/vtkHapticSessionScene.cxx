// SPDX-License-Identifier: GPL-3.0-or-later
// The surfaces of the scene: put together, committed, and what came of them.
#include <algorithm>

#include "vtkHapticSessionInternals.h"

void vtkHapticSession::ClearSurfaces()
{
  this->Impl->Worker.Clear();
  if (this->Impl->ProblemOf.starts_with(Internals::OfSurface))
  {
    this->Impl->ProblemOf = Internals::OfFormerSurface;
  }
}

bool vtkHapticSession::AddSurface(const char* name, vtkDataObject* data, vtkMatrix4x4* matrix)
{
  const std::string known = name ? name : "surface";
  const std::string problem = this->Impl->Worker.Add(known, data, matrix);
  this->Refuse(problem);
  this->Impl->Follow(Internals::OfSurface + known, problem);
  return problem.empty();
}

void vtkHapticSession::CommitScene()
{
  this->Impl->Follow(Internals::OfFormerSurface, "");
  this->Impl->Simpler.Cancel();
  this->Impl->Worker.Follow(this->Impl->Core.running() ? this->Impl->Full.Scene : nullptr);
  this->Impl->Worker.Commit(this->Impl->Now());
}

bool vtkHapticSession::FinishScene()
{
  this->Impl->TakeScene(this->Impl->Worker.Wait());
  this->Impl->FollowRadius();
  return this->Impl->Built.Scene != nullptr;
}

bool vtkHapticSession::GetSceneBounds(double bounds[6]) const
{
  std::copy(this->Impl->Built.Bounds.begin(), this->Impl->Built.Bounds.end(), bounds);
  return this->Impl->Built.Scene != nullptr;
}

const char* vtkHapticSession::GetSceneReport() const
{
  return this->Impl->Built.Report.c_str();
}
