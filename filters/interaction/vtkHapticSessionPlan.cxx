// SPDX-License-Identifier: GPL-3.0-or-later
// The contact plan of a scene, and whether simpler surfaces of it are touched.
#include "haptics/session/PlanText.h"
#include "vtkHapticSessionInternals.h"
#include "vtkHapticTool.h"

palpate::SimplifyPlan vtkHapticSession::Internals::PlanNow() const
{
  // A tool that lies on triangles may meet those that replace them.
  const auto choice = this->Tool.Choice().tool ? palpate::AutoChoice::Off
                                               : static_cast<palpate::AutoChoice>(this->Settings.whole("Simplify"));
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

bool vtkHapticSession::FinishSimplification()
{
  this->Impl->Scene.follow(this->Impl->PlanNow());
  this->Impl->Scene.takeSimpler(true);
  return this->Impl->Scene.isSimpler();
}

std::string vtkHapticSession::Internals::FollowRadiusLimit()
{
  this->Asked.limitRadius = this->Settings.isOn("LimitRadius");
  this->FollowRadius();
  return {};
}

std::string vtkHapticSession::Internals::FollowSimplify()
{
  this->Scene.follow(this->PlanNow());
  return {};
}

const char* vtkHapticSession::Internals::SayPlanText()
{
  this->PlanText = palpate::planText(this->Scene.choices(), this->Asked.touch(this->Scene.built())) + this->PlaneText();
  return this->PlanText.c_str();
}
