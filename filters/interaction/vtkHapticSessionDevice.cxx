// SPDX-License-Identifier: GPL-3.0-or-later
// Which device is chosen, what it is, what it cannot do, and how the link to it goes.
#include <algorithm>
#include <cmath>

#include "devices/DeviceNotes.h"
#include "devices/calibration/CalibratedDevice.h"
#include "devices/calibration/CalibrationFiles.h"
#include "devices/io/LinkedDevice.h"
#include "vtkHapticSessionInternals.h"

void vtkHapticSession::Internals::LearnDevices()
{
  const auto named = [this](const palpate::KnownDevice& known) { return known.name == this->DeviceName; };
  if (std::none_of(this->Known.begin(), this->Known.end(), named))
  {
    this->Known = palpate::knownDevices(); // it was plugged in after the last look
    palpate::applyCalibrations(this->Known, this->CalibrationFolder);
  }
}

const palpate::LinkedDevice* vtkHapticSession::Internals::Linked()
{
  palpate::HapticDevice* device = this->Core.device();
  if (const auto* calibrated = dynamic_cast<palpate::CalibratedDevice*>(device))
  {
    device = &calibrated->inner();
  }
  return dynamic_cast<palpate::LinkedDevice*>(device);
}

palpate::LinkReport vtkHapticSession::Internals::Link()
{
  const palpate::LinkedDevice* const linked = this->Linked();
  return linked ? linked->linkReport() : palpate::LinkReport();
}

void vtkHapticSession::SetDeviceName(const char* name)
{
  const std::string wanted = name ? name : "";
  if (wanted == this->Impl->DeviceName)
  {
    return;
  }
  const palpate::MadeDevice made = palpate::makeDevice(wanted, {});
  if (!made.device)
  {
    this->Refuse(made.problem);
    return;
  }
  this->Impl->DeviceName = wanted;
  this->Impl->LearnDevices();
  this->Impl->JudgeStability();
  this->Impl->FollowWalls();
  this->Impl->FollowPlane();
  this->Modified();
}

const char* vtkHapticSession::GetDeviceName() const
{
  return this->Impl->DeviceName.c_str();
}

int vtkHapticSession::GetNumberOfKnownDevices() const
{
  return static_cast<int>(this->Impl->Known.size());
}

const char* vtkHapticSession::GetKnownDeviceName(int index) const
{
  return index >= 0 && index < this->GetNumberOfKnownDevices() ? this->Impl->Known[index].name.c_str() : nullptr;
}

const char* vtkHapticSession::GetKnownDeviceProblem(int index) const
{
  return index >= 0 && index < this->GetNumberOfKnownDevices() ? this->Impl->Known[index].problem.c_str() : nullptr;
}

const char* vtkHapticSession::GetDeviceKind() const
{
  this->Impl->DeviceKind = palpate::kindOf(this->Impl->ChosenInfo());
  return this->Impl->DeviceKind.c_str();
}

const char* vtkHapticSession::GetDeviceNotes() const
{
  palpate::DeviceInfo info = this->Impl->ChosenInfo();
  if (const palpate::LinkedDevice* const linked = this->Impl->Linked())
  {
    info.abilities = linked->abilitiesNow();
  }
  this->Impl->DeviceNotes = palpate::shortcomings(info);
  return this->Impl->DeviceNotes.c_str();
}

const char* vtkHapticSession::GetLinkText() const
{
  std::string& text = this->Impl->LinkText;
  text.clear();
  if (this->Impl->Linked())
  {
    const palpate::LinkReport link = this->Impl->Link();
    text = std::to_string(std::lround(link.inputRate_Hz)) + " reports a second, " + std::to_string(link.restarts) +
           " effects renewed, " + std::to_string(link.stalls) + " stalls, " + std::to_string(link.losses) +
           " losses, " + std::to_string(link.strange) + " strange" + (link.attached ? "" : "; not there") +
           (link.message.empty() ? "" : ": " + link.message);
  }
  return text.c_str();
}

double vtkHapticSession::GetLinkRate() const
{
  return this->Impl->Link().inputRate_Hz;
}

vtkIdType vtkHapticSession::GetLinkStalls() const
{
  return static_cast<vtkIdType>(this->Impl->Link().stalls);
}

vtkIdType vtkHapticSession::GetLinkLosses() const
{
  return static_cast<vtkIdType>(this->Impl->Link().losses);
}

vtkIdType vtkHapticSession::GetLinkStrange() const
{
  return static_cast<vtkIdType>(this->Impl->Link().strange);
}

vtkIdType vtkHapticSession::GetLinkRestarts() const
{
  return static_cast<vtkIdType>(this->Impl->Link().restarts);
}
