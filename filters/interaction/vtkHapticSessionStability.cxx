// SPDX-License-Identifier: GPL-3.0-or-later
// The measures that keep a held force from shaking the hand, and their cost.
#include "haptics/session/DeviceAdaptation.h"
#include "haptics/session/SessionWorkers.h"
#include "vtkHapticSessionInternals.h"

void vtkHapticSession::Internals::JudgeStability()
{
  if (this->Core.running())
  {
    this->Limits = this->Core.limits();
    this->StabilityText = this->Core.limitsText();
    return;
  }
  const palpate::JudgedLoop judged = palpate::judgeLoop(
    this->Asked.asked(), this->Chosen.info, PeriodSeconds, this->Core.chosen<palpate::ToolTask>().weighs_u());
  this->Limits = judged.limits;
  this->StabilityText = judged.sentence;
}

bool vtkHapticSession::GetDeviceTakesHand() const
{
  return palpate::deviceModel(this->Impl->Chosen.name) != nullptr;
}
