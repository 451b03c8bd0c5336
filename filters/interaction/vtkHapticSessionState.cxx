// SPDX-License-Identifier: GPL-3.0-or-later
// What a session says about itself.
#include "devices/common/LinkNotes.h"
#include "vtkHapticSessionInternals.h"

int vtkHapticSession::GetEngageState() const
{
  return static_cast<int>(this->Impl->State.engage);
}

const char* vtkHapticSession::GetStateText() const
{
  return palpate::name(this->Impl->State.engage);
}

const char* vtkHapticSession::GetFaultText() const
{
  if (this->Impl->Report.ended)
  {
    return "The hand's path has ended: start touching again.";
  }
  const palpate::Fault fault = this->GetTouching() ? this->Impl->State.fault : palpate::Fault::None;
  if (fault == palpate::Fault::DeviceLost)
  {
    this->Impl->LossText = palpate::describeLoss(this->Impl->Link());
    return this->Impl->LossText.c_str();
  }
  return fault == palpate::Fault::None ? "" : palpate::describe(fault);
}

const char* vtkHapticSession::GetProblem() const
{
  return this->Impl->Problem.c_str();
}

const char* vtkHapticSession::GetWarning() const
{
  return this->Impl->Warning.c_str();
}

double* vtkHapticSession::GetProxyPosition()
{
  return this->Impl->Proxy;
}

double* vtkHapticSession::GetHandPosition()
{
  return this->Impl->Hand;
}

double* vtkHapticSession::GetForce()
{
  return this->Impl->Force;
}

double vtkHapticSession::GetForceMagnitude() const
{
  return this->Impl->State.force_W.norm();
}

double vtkHapticSession::GetPeakForce() const
{
  return this->Impl->Report.peakForce_N;
}

int vtkHapticSession::GetContacts() const
{
  return this->Impl->State.contacts;
}

double vtkHapticSession::GetDepth() const
{
  return (this->Impl->State.proxy_W.p - this->Impl->State.device_W.p).norm();
}

vtkIdType vtkHapticSession::GetTicks() const
{
  return static_cast<vtkIdType>(this->Impl->Report.ticks);
}

vtkIdType vtkHapticSession::GetMissed() const
{
  return static_cast<vtkIdType>(this->Impl->Report.missed);
}

vtkIdType vtkHapticSession::GetPeriods() const
{
  return static_cast<vtkIdType>(this->Impl->Report.periods);
}

vtkIdType vtkHapticSession::GetCappedTicks() const
{
  return static_cast<vtkIdType>(this->Impl->Report.cappedTicks);
}

double vtkHapticSession::GetContactSeconds() const
{
  return static_cast<double>(this->Impl->Report.contactTicks) * Internals::PeriodSeconds;
}

double vtkHapticSession::GetForceResidual() const
{
  return this->Impl->Report.forceResidual_N;
}

double vtkHapticSession::GetRate() const
{
  const palpate::LoopReport& report = this->Impl->Report;
  return report.elapsed_s > 0.0 ? static_cast<double>(report.ticks) / report.elapsed_s : 0.0;
}

double vtkHapticSession::GetLatenessP50() const
{
  return this->Impl->Report.lateness.p50_us;
}

double vtkHapticSession::GetLatenessP99() const
{
  return this->Impl->Report.lateness.p99_us;
}

double vtkHapticSession::GetCostP50() const
{
  return this->Impl->Report.cost.p50_us;
}

double vtkHapticSession::GetCostP99() const
{
  return this->Impl->Report.cost.p99_us;
}

double vtkHapticSession::GetCostP999() const
{
  return this->Impl->Report.cost.p999_us;
}

const char* vtkHapticSession::GetSchedulingReport() const
{
  return this->Impl->Scheduling.c_str();
}
