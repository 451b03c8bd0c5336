// SPDX-License-Identifier: GPL-3.0-or-later
// A body that gives way.
#include "vtkHapticHeldMechanism.h"
#include "vtkHapticHeldTool.h"
#include "vtkHapticPressedBody.h"
#include "vtkHapticSessionInternals.h"
#include "vtkUnstructuredGrid.h"

bool vtkHapticSession::AddSoftBody(const char* name, vtkDataObject* data)
{
  Internals& impl = *this->Impl;
  const std::string problem = impl.Soft.Take(name ? name : "", data);
  this->Impl->Refuse(problem);
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

std::string vtkHapticSession::Internals::FollowSoftSource()
{
  this->Soft.Source = this->Settings.text("SoftSource");
  this->Session.AddSoftBody(nullptr, nullptr);
  return {};
}

std::string vtkHapticSession::Internals::FollowSoftRate()
{
  this->Soft.Rate_Hz = this->Settings.number("SoftRate");
  this->Core.setSoft(this->Soft.Choice());
  this->Core.setMechanism(this->Mechanism.Choice(this->Soft.Rate_Hz));
  return {};
}
