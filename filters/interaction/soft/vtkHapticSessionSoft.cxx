// SPDX-License-Identifier: GPL-3.0-or-later
// A body that gives way.
#include "vtkHapticSessionInternals.h"
#include "vtkUnstructuredGrid.h"

bool vtkHapticSession::AddSoftBody(const char* name, vtkDataObject* data)
{
  Internals& impl = *this->Impl;
  const std::string problem = impl.Soft.Take(name ? name : "", data);
  this->Refuse(problem);
  impl.Follow("soft body", problem);
  impl.Core.setSoft(impl.Soft.Choice());
  if (impl.Core.tool().tool)
  {
    impl.Follow("tool", impl.Core.toolBesideSoft());
    impl.JudgeStability();
    impl.Tool.Follow(impl.Core, impl.State);
  }
  impl.Soft.Follow(impl.Core, impl.State, impl.Now());
  return problem.empty();
}

bool vtkHapticSession::BendSoftBody(vtkDataObject* body)
{
  auto* const grid = vtkUnstructuredGrid::SafeDownCast(body);
  return grid && this->Impl->Soft.Bend(*grid);
}

void vtkHapticSession::SetSoftSource(const char* name)
{
  const std::string source = name ? name : "";
  if (source != this->Impl->Soft.Source)
  {
    this->Impl->Soft.Source = source;
    this->AddSoftBody(nullptr, nullptr);
    this->Modified();
  }
}

const char* vtkHapticSession::GetSoftSource() const
{
  return this->Impl->Soft.Source.c_str();
}

void vtkHapticSession::SetSoftRate(double rate_Hz)
{
  if (this->Allows("SoftRate", { rate_Hz }) && rate_Hz != this->Impl->Soft.Rate_Hz)
  {
    this->Impl->Soft.Rate_Hz = rate_Hz;
    this->Impl->Core.setSoft(this->Impl->Soft.Choice());
    this->Impl->Core.setMechanism(this->Impl->Mechanism.Choice(rate_Hz));
    this->Modified();
  }
}

double vtkHapticSession::GetSoftRate() const
{
  return this->Impl->Soft.Rate_Hz;
}

const char* vtkHapticSession::GetSoftText() const
{
  return this->Impl->Soft.Text.c_str();
}

double vtkHapticSession::GetSoftStrain() const
{
  return this->Impl->Soft.Strain;
}

double vtkHapticSession::GetSoftPackets() const
{
  return this->Impl->Soft.PacketsPerSecond;
}

double vtkHapticSession::GetSoftAge() const
{
  return this->Impl->State.soft.age_s;
}

void vtkHapticSession::SetShowSoftHand(bool on)
{
  this->Impl->Soft.ShowHand = on;
  this->Modified();
}

bool vtkHapticSession::GetShowSoftHand() const
{
  return this->Impl->Soft.ShowHand;
}

double* vtkHapticSession::GetSoftHandPosition()
{
  return this->Impl->Soft.Hand_W.data();
}
