// SPDX-License-Identifier: GPL-3.0-or-later
// By what a scene is touched, and whether simpler surfaces of it are.
#include "haptics/session/PlanSentence.h"
#include "vtkHapticSessionInternals.h"

palpate::SimplifyPlan vtkHapticSession::Internals::PlanNow() const
{
  // A tool that lies on triangles may meet those that replace them.
  const auto choice =
    this->Tool.Choice().tool ? palpate::AutoChoice::Off : static_cast<palpate::AutoChoice>(this->Simplify);
  return palpate::simplifyPlan(choice, this->Asked.asked().map.scale_u_per_m, this->InfoNow());
}

void vtkHapticSession::Internals::FollowRadius()
{
  const std::optional<palpate::HapticParameters> told = this->Asked.otherBall(this->Scene.built());
  if (told && this->Scene.isTaken() && this->Core.setParameters(*told).empty())
  {
    this->Asked.ballTaken(*told);
  }
}

void vtkHapticSession::SetLimitRadius(bool on)
{
  if (on != this->Impl->Asked.limitRadius)
  {
    this->Impl->Asked.limitRadius = on;
    this->Impl->FollowRadius();
    this->Modified();
  }
}

bool vtkHapticSession::GetLimitRadius() const
{
  return this->Impl->Asked.limitRadius;
}

double vtkHapticSession::GetRadiusLimit() const
{
  return this->Impl->Scene.built().largestRadius_u;
}

double vtkHapticSession::GetRadiusUsed() const
{
  return this->Impl->Asked.touch(this->Impl->Scene.built()).plan.radius_u;
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

const char* vtkHapticSession::GetPlanSentence() const
{
  this->Impl->PlanSentence =
    palpate::planSentence(this->Impl->Scene.choices(), this->Impl->Asked.touch(this->Impl->Scene.built())) +
    this->Impl->PlaneSentence();
  return this->Impl->PlanSentence.c_str();
}
