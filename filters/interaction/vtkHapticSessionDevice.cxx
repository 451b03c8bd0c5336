// SPDX-License-Identifier: GPL-3.0-or-later
// Which device is chosen, what it is, what it cannot do, and how the link to it goes.
#include <algorithm>
#include <utility>

#include "devices/calibration/CalibratedDevice.h"
#include "devices/calibration/CalibrationFiles.h"
#include "devices/common/DeviceNotes.h"
#include "devices/common/LinkNotes.h"
#include "devices/common/LinkedDevice.h"
#include "vtkHapticSessionInternals.h"

void vtkHapticSession::Internals::LookForDevices()
{
  this->Known = palpate::knownDevices(this->Options());
  palpate::applyCalibrations(this->Known, this->CalibrationFolder, this->Felt);
  this->LearnChosen();
}

void vtkHapticSession::Internals::LearnChosen()
{
  const auto named = [this](const palpate::KnownDevice& known) { return known.name == this->Chosen.name; };
  const auto found = std::find_if(this->Known.begin(), this->Known.end(), named);
  if (found != this->Known.end())
  {
    this->Chosen = *found;
    this->Chosen.info = this->Wheel ? palpate::asWheel(found->info) : found->info;
  }
  else
  {
    this->Chosen.problem = "it is not plugged in";
  }
}

const std::string& vtkHapticSession::Internals::DeviceNameNow() const
{
  return this->Running ? this->Running->DeviceName : this->Chosen.name;
}

const palpate::DeviceInfo& vtkHapticSession::Internals::InfoNow() const
{
  return this->Running ? this->Running->Info : this->Chosen.info;
}

bool vtkHapticSession::Internals::VirtualTimeNow() const
{
  return this->Running ? this->Running->VirtualTime : this->VirtualTime;
}

void vtkHapticSession::Internals::FollowDevice()
{
  if (this->RaisesLines() != this->Raises)
  {
    this->FollowWalls();
  }
  this->FollowPlane();
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
  if (wanted == this->Impl->Chosen.name)
  {
    return;
  }
  palpate::DeviceOptions options;
  options.hid = this->Impl->Bus;
  options.wheel = this->Impl->Wheel;
  const palpate::MadeDevice made = palpate::makeDevice(wanted, options);
  if (!made.device)
  {
    this->Refuse(made.problem);
    return;
  }
  this->Impl->Chosen = { wanted, "", made.device->info(), "" };
  this->Impl->LearnChosen();
  if (!this->Impl->Chosen.problem.empty())
  {
    this->Impl->LookForDevices(); // it may have been plugged in after the last look
  }
  this->Impl->JudgeStability();
  this->Impl->FollowDevice();
  this->Modified();
}

const char* vtkHapticSession::GetDeviceName() const
{
  return this->Impl->Chosen.name.c_str();
}

void vtkHapticSession::SetWheel(bool on)
{
  if (on != this->Impl->Wheel)
  {
    this->Impl->Wheel = on;
    this->Impl->LearnChosen();
    this->Impl->JudgeStability();
    this->Impl->FollowDevice();
    this->Modified();
  }
}

bool vtkHapticSession::GetWheel() const
{
  return this->Impl->Wheel;
}

void vtkHapticSession::LookForDevices()
{
  this->Impl->LookForDevices();
  this->Impl->JudgeStability();
  this->Impl->FollowDevice();
}

void vtkHapticSession::SetHidBus(std::shared_ptr<palpate::HidBus> bus)
{
  this->Impl->Bus = std::move(bus);
  this->LookForDevices();
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

bool vtkHapticSession::GetKnownDeviceForPrograms(int index) const
{
  return index >= 0 && index < this->GetNumberOfKnownDevices() && this->Impl->Known[index].forPrograms;
}

const char* vtkHapticSession::GetPreferredDevice() const
{
  this->Impl->Preferred = palpate::preferredDevice(this->Impl->Known);
  return this->Impl->Preferred.c_str();
}

const char* vtkHapticSession::GetDeviceKind() const
{
  this->Impl->DeviceKind = palpate::kindOf(this->Impl->Chosen.info);
  return this->Impl->DeviceKind.c_str();
}

const char* vtkHapticSession::GetDeviceNotes() const
{
  const Internals& impl = *this->Impl;
  palpate::DeviceInfo info = impl.Chosen.info;
  const bool runs = impl.Running && impl.Running->DeviceName == impl.Chosen.name;
  if (const palpate::LinkedDevice* const linked = runs ? this->Impl->Linked() : nullptr)
  {
    info.abilities = linked->abilitiesNow();
  }
  const std::string problem = runs || impl.Chosen.problem.empty() ? "" : "Cannot be used now: " + impl.Chosen.problem;
  std::string notes = palpate::shortcomings(info);
  notes += impl.Chosen.hasTwin ? (notes.empty() ? "" : " ") + std::string(palpate::twinNote) : "";
  const bool neverHeld = impl.Asked.asked().safety.deadMan.grip && !impl.Chosen.hasGrip && info.rendersForce;
  notes += neverHeld ? (notes.empty() ? "" : " ") + std::string(palpate::noGripNote) : "";
  this->Impl->DeviceNotes = problem + (problem.empty() || notes.empty() ? "" : ". ") + notes;
  return this->Impl->DeviceNotes.c_str();
}

const char* vtkHapticSession::GetLinkText() const
{
  std::string& text = this->Impl->LinkText;
  text.clear();
  if (this->Impl->Linked())
  {
    text = palpate::describeLink(this->Impl->Link());
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
