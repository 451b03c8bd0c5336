// SPDX-License-Identifier: GPL-3.0-or-later
// Which devices there are, and how the link to the one that runs goes.
#include "vtkHapticKnownDevices.h"

#include <utility>

#include "devices/common/LinkedDevice.h"
#include "vtkHapticSessionInternals.h"

vtkSmartPointer<vtkHapticKnownDevices> vtkHapticKnownDevices::Of(vtkHapticSession& session)
{
  return vtkSmartPointer<vtkHapticKnownDevices>::Take(new vtkHapticKnownDevices(session));
}

void vtkHapticKnownDevices::Look()
{
  this->Behind().LookForDevices();
  this->Behind().JudgeStability();
  this->Behind().FollowDevice();
}

void vtkHapticKnownDevices::SetHidBus(std::shared_ptr<palpate::HidBus> bus)
{
  this->Behind().Bus = std::move(bus);
  this->Look();
}

int vtkHapticKnownDevices::GetNumberOfDevices() const
{
  return static_cast<int>(this->Behind().Known.size());
}

const char* vtkHapticKnownDevices::GetName(int index) const
{
  return index >= 0 && index < this->GetNumberOfDevices() ? this->Behind().Known[index].name.c_str() : nullptr;
}

const char* vtkHapticKnownDevices::GetProblem(int index) const
{
  return index >= 0 && index < this->GetNumberOfDevices() ? this->Behind().Known[index].problem.c_str() : nullptr;
}

bool vtkHapticKnownDevices::GetForPrograms(int index) const
{
  return index >= 0 && index < this->GetNumberOfDevices() && this->Behind().Known[index].forPrograms;
}

const char* vtkHapticKnownDevices::GetPreferred() const
{
  this->Behind().Preferred = palpate::preferredDevice(this->Behind().Known);
  return this->Behind().Preferred.c_str();
}

double vtkHapticKnownDevices::GetLinkRate() const
{
  return this->Behind().Link().inputRate_Hz;
}

vtkIdType vtkHapticKnownDevices::GetLinkStalls() const
{
  return static_cast<vtkIdType>(this->Behind().Link().stalls);
}

vtkIdType vtkHapticKnownDevices::GetLinkLosses() const
{
  return static_cast<vtkIdType>(this->Behind().Link().losses);
}

vtkIdType vtkHapticKnownDevices::GetLinkStrange() const
{
  return static_cast<vtkIdType>(this->Behind().Link().strange);
}

vtkIdType vtkHapticKnownDevices::GetLinkRestarts() const
{
  return static_cast<vtkIdType>(this->Behind().Link().restarts);
}
