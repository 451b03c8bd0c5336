// SPDX-License-Identifier: GPL-3.0-or-later
// What is felt of a scene: all of its triangles and segments first, fewer of them where nobody can tell.
#include <algorithm>
#include <utility>

#include "haptics/contact/view/PlanFor.h"
#include "haptics/session/PlanSentence.h"
#include "vtkHapticSessionInternals.h"

namespace
{
bool Searched(const palpate::SurfaceChoice& choice)
{
  return choice.reason.empty();
}
} // namespace

palpate::SimplifyRules vtkHapticSession::Internals::RulesNow() const
{
  palpate::SimplifyRules rules;
  rules.touch.scale_u_per_m = this->Parameters.map.scale_u_per_m;
  rules.touch.resolution_m = this->InfoNow().resolution_m.value;
  if (this->Simplify == On)
  {
    rules.leastTriangles = rules.leastFine = 0;
  }
  return rules;
}

void vtkHapticSession::Internals::PlanScene()
{
  this->Simpler.Cancel();
  this->Choices.clear();
  this->Rules = this->RulesNow();
  if (!this->Full.Scene)
  {
    return;
  }
  this->Choices = palpate::chooseAtFirst(*this->Full.Scene, this->Full.Traits, this->Rules);
  if (this->Simplify == Off)
  {
    std::for_each(this->Choices.begin(), this->Choices.end(),
      [](palpate::SurfaceChoice& choice) { choice.reason = "simpler surfaces are off"; });
  }
  if (std::any_of(this->Choices.begin(), this->Choices.end(), Searched) &&
      this->Simpler.Follow(this->Full.Scene, this->Choices, this->Rules, this->Worker.TakeRevision()))
  {
    this->TakeSimpler(this->Simpler.Poll());
  }
}

void vtkHapticSession::Internals::FollowRules()
{
  const palpate::SimplifyRules now = this->RulesNow();
  const palpate::TouchConditions &then = this->Rules.touch, &touch = now.touch;
  if (then.scale_u_per_m == touch.scale_u_per_m && then.resolution_m == touch.resolution_m)
  {
    return;
  }
  this->RestoreFull();
  this->PlanScene();
}

void vtkHapticSession::Internals::RestoreFull()
{
  if (this->Built.Scene != this->Full.Scene)
  {
    this->Built = this->Full;
    this->Core.setScene(this->Built.Scene);
  }
}

void vtkHapticSession::Internals::TakeSimpler(std::optional<vtkHapticFoundScene> found)
{
  if (!found)
  {
    return;
  }
  this->Choices = std::move(found->choices);
  if (!found->scene)
  {
    return;
  }
  for (const palpate::SurfaceChoice& choice : this->Choices)
  {
    if (choice.felt < choice.triangles)
    {
      this->Built.Report += choice.name + ": " + palpate::planSentence(choice) + "\n";
    }
  }
  this->Built.Scene = std::move(found->scene);
  this->Built.LargestRadius_u = found->LargestRadius_u;
  this->Core.setScene(this->Built.Scene);
}

palpate::HapticParameters vtkHapticSession::Internals::Allowed(palpate::HapticParameters asked) const
{
  asked.contact.radius_u =
    palpate::chosenRadius_u(asked.contact.radius_u, this->Built.LargestRadius_u, this->LimitRadius);
  return asked;
}

void vtkHapticSession::Internals::FollowRadius()
{
  const palpate::HapticParameters allowed = this->Allowed(this->Parameters);
  const palpate::Scene* const scene = this->Built.Scene.get();
  const bool felt = !this->Core.running() || !scene || this->Core.state().sceneRevision == scene->revision();
  if (felt && allowed.contact.radius_u != this->RadiusUsed_u && this->Core.setParameters(allowed).empty())
  {
    this->RadiusUsed_u = allowed.contact.radius_u;
  }
}

void vtkHapticSession::SetLimitRadius(bool on)
{
  if (on != this->Impl->LimitRadius)
  {
    this->Impl->LimitRadius = on;
    this->Impl->FollowRadius();
    this->Modified();
  }
}

bool vtkHapticSession::GetLimitRadius() const
{
  return this->Impl->LimitRadius;
}

double vtkHapticSession::GetRadiusLimit() const
{
  return this->Impl->Built.LargestRadius_u;
}

double vtkHapticSession::GetRadiusUsed() const
{
  return this->Impl->Touch().plan.radius_u;
}

void vtkHapticSession::SetSimplify(int choice)
{
  if (this->Allows("Simplify", { static_cast<double>(choice) }) && choice != this->Impl->Simplify)
  {
    this->Impl->Simplify = choice;
    this->Impl->RestoreFull();
    this->Impl->PlanScene();
    this->Modified();
  }
}

int vtkHapticSession::GetSimplify() const
{
  return this->Impl->Simplify;
}

bool vtkHapticSession::FinishSimplification()
{
  this->Impl->FollowRules();
  this->Impl->TakeSimpler(this->Impl->Simpler.Wait());
  return this->Impl->Built.Scene != this->Impl->Full.Scene;
}

palpate::TouchChoice vtkHapticSession::Internals::Touch() const
{
  const palpate::Scene* const scene = this->Built.Scene.get();
  palpate::TouchChoice touch;
  touch.plan = this->Parameters.contact;
  touch.plan.radius_u = this->RadiusUsed_u;
  touch.asked_u = this->Parameters.contact.radius_u;
  touch.largest_u = this->Built.LargestRadius_u;
  if (scene)
  {
    touch.plan = palpate::planFor(*scene, touch.plan);
    touch.frictionFromData = palpate::hasOwnFriction(*scene);
  }
  return touch;
}

const char* vtkHapticSession::GetPlanSentence() const
{
  this->Impl->PlanSentence =
    palpate::planSentence(this->Impl->Choices, this->Impl->Touch()) + this->Impl->PlaneSentence();
  return this->Impl->PlanSentence.c_str();
}
