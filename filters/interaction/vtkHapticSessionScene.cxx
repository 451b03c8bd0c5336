// SPDX-License-Identifier: GPL-3.0-or-later
// The surfaces of the scene: put together, committed, and taken over.
#include <algorithm>

#include "haptics/session/plan/FittedMap.h"
#include "vtkCommand.h"
#include "vtkHapticHeldMechanism.h"
#include "vtkHapticSceneSurfaces.h"
#include "vtkHapticSessionInternals.h"
#include "vtkHapticTool.h"

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
  this->Impl->Refuse(problem);
  this->Impl->Follow(Internals::OfSurface + known, problem);
  return problem.empty();
}

void vtkHapticSession::CommitScene()
{
  this->Impl->Follow(Internals::OfFormerSurface, "");
  this->Impl->Cancelled.clear();
  this->Impl->Scene.beforeCommit();
  this->Impl->Surfaces.Commit(this->Impl->Scene.worker(), this->Impl->Now());
}

void vtkHapticSession::Internals::FollowCommit()
{
  if (this->CommitSeen != this->Surfaces.Commits())
  {
    this->CommitSeen = this->Surfaces.Commits();
    this->ForgetContact();
    this->JudgeMarks();
    this->MissingArrays = this->Surfaces.MissingArrays();
  }
}

void vtkHapticSession::Internals::TakeScene(bool wait)
{
  this->Scene.seeFrom(this->Session.GetFollowsMouse() ? this->Eye_W : std::nullopt);
  if (!this->Scene.takeBuilt(this->PlanNow(), this->Now(), wait))
  {
    return;
  }
  this->Surfaces.Took(this->Scene.worker());
  if (!this->Scene.built().scene || !this->Scene.built().scene->moves())
  {
    this->JudgeLoose();
  }
  this->FollowPlane();
  this->StayOutside(this->Scene.cameAround());
  const bool ofTouch = this->Core.running() && palpate::isOfTouch(this->Scene.built().stamp_s, this->Begun_s);
  if (this->Scene.built().scene && (this->FitAsked || (ofTouch && this->FitsNow())))
  {
    this->Fit();
    return;
  }
  this->FollowCameAround();
}

void vtkHapticSession::Internals::TakeOutSqueezed()
{
  if (this->Scene.takeOutSqueezed())
  {
    this->StayOutside(this->Scene.cameAround());
    this->FollowCameAround();
  }
}

void vtkHapticSession::Internals::FollowCameAround()
{
  if (this->Scene.cameAround())
  {
    this->LeadMouseAnew();
  }
}

void vtkHapticSession::Internals::LeadMouseAnew()
{
  if (this->Session.GetFollowsMouse())
  {
    this->Session.InvokeEvent(vtkCommand::StartEvent);
    this->Feed(true);
  }
}

void vtkHapticSession::Internals::StayOutside(const std::optional<palpate::CameAround>& around)
{
  this->Around.clear();
  if (!around || this->Tool.Choice().tool) // a tool stays on its side by itself
  {
    return;
  }
  const palpate::HandHolder holder = this->DeviceNameNow() == "mouse" ? palpate::HandHolder::Mouse
                                     : this->InfoNow().rendersForce   ? palpate::HandHolder::Device
                                                                      : palpate::HandHolder::Program;
  const palpate::StayOutside verdict =
    palpate::stayOutside(*around, holder, this->Core.state().device_W.p, this->Core.parameters());
  if (verdict.letGo)
  {
    this->Core.release();
    this->Core.engage(); // waits until the force would start small
  }
  this->Around = verdict.sentence;
  this->AroundSaid_s = this->Now();
}

void vtkHapticSession::Internals::ForgetAround()
{
  constexpr double read_s = 5.0;
  if (this->State.engage == palpate::EngageState::Engaged && this->Now() > this->AroundSaid_s + read_s)
  {
    this->Around.clear();
  }
}

void vtkHapticSession::CancelScene()
{
  Internals& impl = *this->Impl;
  if (this->GetSceneProgress() < 1.0)
  {
    impl.Surfaces.Cancel(impl.Scene.worker());
    impl.FitAsked = false;
    ++impl.ScenesCancelled;
    impl.Cancelled = "the preparation of the visible data was cancelled: press Touch to try again";
  }
}

bool vtkHapticSession::FinishScene()
{
  this->Impl->TakeScene(true);
  this->Impl->FollowRadius();
  return this->Impl->Scene.built().scene != nullptr;
}

bool vtkHapticSession::GetSceneBounds(double bounds[6]) const
{
  const palpate::BuiltScene shown = this->Impl->Fittable();
  std::copy(shown.bounds.begin(), shown.bounds.end(), bounds);
  const vtkBoundingBox& joined = this->Impl->Mechanism.Bounds;
  if (!this->Impl->IsFittable() && joined.IsValid())
  {
    joined.GetBounds(bounds);
  }
  return this->Impl->IsFittable() || joined.IsValid();
}
