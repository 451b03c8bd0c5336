// SPDX-License-Identifier: GPL-3.0-or-later
// What keeps a held force from shaking the hand, and what that costs.
#include "haptics/session/DeviceAdaptation.h"
#include "vtkHapticSessionInternals.h"

void vtkHapticSession::Internals::JudgeStability()
{
  if (this->Core.running())
  {
    this->Limits = this->Core.limits();
    this->StabilitySentence = this->Core.limitsSentence();
    return;
  }
  const palpate::JudgedLoop judged =
    palpate::judgeLoop(this->Asked.asked(), this->Chosen.info, PeriodSeconds, this->Core.tool().weighs_u());
  this->Limits = judged.limits;
  this->StabilitySentence = judged.sentence;
}

// Settings ----------------------------------------------------------------------------------------------------------

void vtkHapticSession::SetHand(const char* name)
{
  const std::string wanted = name ? name : "";
  palpate::DeviceOptions options;
  options.hand = wanted;
  const palpate::MadeDevice made = palpate::makeDevice(palpate::deviceModels().front().name, options);
  if (!made.device)
  {
    this->Refuse(made.problem);
    return;
  }
  if (wanted != this->Impl->HeldBy)
  {
    this->Impl->HeldBy = wanted;
    this->Modified();
  }
}

const char* vtkHapticSession::GetHand() const
{
  return this->Impl->HeldBy.c_str();
}

bool vtkHapticSession::GetDeviceTakesHand() const
{
  return palpate::deviceModel(this->Impl->Chosen.name) != nullptr;
}

// What it says ------------------------------------------------------------------------------------------------------

double vtkHapticSession::GetLargestStiffness() const
{
  return this->Impl->Limits.largest_N_per_m;
}

const char* vtkHapticSession::GetStabilitySentence() const
{
  return this->Impl->StabilitySentence.c_str();
}

double vtkHapticSession::GetStiffnessUsed() const
{
  return this->Impl->State.stiffness_N_per_m;
}

bool vtkHapticSession::GetStiffnessLimited() const
{
  return this->Impl->State.stiffnessLimited;
}

double vtkHapticSession::GetStabiliserForce() const
{
  return this->Impl->State.stabiliser_D.norm();
}

double vtkHapticSession::GetPeakStabiliserForce() const
{
  return this->Impl->Report.peakStabiliser_N;
}

double vtkHapticSession::GetDeliveredEnergy() const
{
  return this->Impl->State.energy.delivered_J;
}

double vtkHapticSession::GetExcessEnergy() const
{
  return this->Impl->State.energy.excess_J;
}

double vtkHapticSession::GetPeakExcessEnergy() const
{
  return this->Impl->State.energy.peakExcess_J;
}
