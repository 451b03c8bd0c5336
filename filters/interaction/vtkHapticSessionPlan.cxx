// SPDX-License-Identifier: GPL-3.0-or-later
// By what a scene is touched, and whether simpler surfaces of it are.
#include "haptics/contact/view/PlanFor.h"
#include "haptics/session/PlanSentence.h"
#include "vtkHapticSessionInternals.h"

palpate::SimplifyPlan vtkHapticSession::Internals::PlanNow() const
{
  return palpate::simplifyPlan(
    static_cast<palpate::AutoChoice>(this->Simplify), this->Parameters.map.scale_u_per_m, this->InfoNow());
}

palpate::HapticParameters vtkHapticSession::Internals::Allowed(palpate::HapticParameters asked) const
{
  asked.contact.radius_u =
    palpate::chosenRadius_u(asked.contact.radius_u, this->Scene.built().largestRadius_u, this->LimitRadius);
  return asked;
}

void vtkHapticSession::Internals::FollowRadius()
{
  const palpate::HapticParameters allowed = this->Allowed(this->Parameters);
  if (allowed.contact.radius_u != this->RadiusUsed_u && this->Scene.isTaken() &&
      this->Core.setParameters(allowed).empty())
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
  return this->Impl->Scene.built().largestRadius_u;
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
    this->Impl->Scene.follow(this->Impl->PlanNow());
    this->Modified();
  }
}

int vtkHapticSession::GetSimplify() const
{
  return this->Impl->Simplify;
}

bool vtkHapticSession::FinishSimplification()
{
  this->Impl->Scene.follow(this->Impl->PlanNow());
  this->Impl->Scene.takeSimpler(true);
  return this->Impl->Scene.isSimpler();
}

palpate::TouchChoice vtkHapticSession::Internals::Touch() const
{
  const palpate::Scene* const scene = this->Scene.built().scene.get();
  palpate::TouchChoice touch;
  touch.plan = this->Parameters.contact;
  touch.plan.radius_u = this->RadiusUsed_u;
  touch.asked_u = this->Parameters.contact.radius_u;
  touch.largest_u = this->Scene.built().largestRadius_u;
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
    palpate::planSentence(this->Impl->Scene.choices(), this->Impl->Touch()) + this->Impl->PlaneSentence();
  return this->Impl->PlanSentence.c_str();
}
