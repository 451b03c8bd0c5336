// SPDX-License-Identifier: GPL-3.0-or-later
// The chosen device: its numbers, its limits, and the state of its link.
#include <algorithm>
#include <optional>
#include <utility>

#include "devices/calibration/CalibratedDevice.h"
#include "devices/calibration/CalibrationFiles.h"
#include "devices/common/DeviceNotes.h"
#include "devices/common/DeviceSteps.h"
#include "devices/common/LinkNotes.h"
#include "devices/common/LinkedDevice.h"
#include "vtkHapticCheckState.h"
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
    this->Chosen.info = this->Settings.isOn("Wheel") ? palpate::asWheel(found->info) : found->info;
  }
  else
  {
    this->Chosen.problem = "the device is not attached";
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
  return this->Running ? this->Running->VirtualTime : this->Settings.isOn("VirtualTime");
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

bool vtkHapticSession::GetFollowsMouse() const
{
  return this->Impl->DeviceNameNow() == "mouse";
}

// Settings ----------------------------------------------------------------------------------------------------------

std::string vtkHapticSession::Internals::FollowDeviceName()
{
  const std::string& wanted = this->Settings.text("DeviceName");
  palpate::DeviceOptions options;
  options.hid = this->Bus;
  options.wheel = this->Settings.isOn("Wheel");
  const palpate::MadeDevice made = palpate::makeDevice(wanted, options);
  if (!made.device)
  {
    return made.problem;
  }
  this->Chosen = { wanted, "", made.device->info(), "" };
  this->LearnChosen();
  if (!this->Chosen.problem.empty())
  {
    this->LookForDevices(); // it may have been plugged in after the last look
  }
  this->JudgeStability();
  this->FollowDevice();
  return {};
}

std::string vtkHapticSession::Internals::FollowWheel()
{
  this->LearnChosen();
  this->JudgeStability();
  this->FollowDevice();
  return {};
}

std::string vtkHapticSession::Internals::FollowHolder()
{
  palpate::DeviceOptions options;
  options.hand = this->Settings.text("Hand");
  return palpate::makeDevice(palpate::deviceModels().front().name, options).problem;
}

const char* vtkHapticSession::Internals::SayDeviceKind()
{
  this->DeviceKind = palpate::kindOf(this->Chosen.info);
  return this->DeviceKind.c_str();
}

const char* vtkHapticSession::Internals::SayDeviceNotes()
{
  palpate::DeviceInfo info = this->Chosen.info;
  const bool runs = this->Running && this->Running->DeviceName == this->Chosen.name;
  if (const palpate::LinkedDevice* const linked = runs ? this->Linked() : nullptr)
  {
    info.abilities = linked->abilitiesNow();
  }
  const std::string problem = runs || this->Chosen.problem.empty() ? "" : "Cannot be used now: " + this->Chosen.problem;
  std::string notes = palpate::shortcomings(info);
  notes += this->Chosen.hasTwin ? (notes.empty() ? "" : " ") + std::string(palpate::twinNote) : "";
  const bool neverHeld = this->Asked.asked().safety.deadMan.grip && !this->Chosen.hasGrip && info.rendersForce;
  notes += neverHeld ? (notes.empty() ? "" : " ") + std::string(palpate::noGripNote) : "";
  this->DeviceNotes = problem + (problem.empty() || notes.empty() ? "" : ". ") + notes;
  return this->DeviceNotes.c_str();
}

const char* vtkHapticSession::Internals::SayLinkText()
{
  std::string& text = this->LinkText;
  text.clear();
  if (this->Linked())
  {
    text = palpate::describeLink(this->Link());
  }
  return text.c_str();
}

const char* vtkHapticSession::Internals::SayDeviceButton()
{
  const auto* const prepared = dynamic_cast<const palpate::PreparedDevice*>(this->Linked());
  std::optional<palpate::DeviceStep> step = prepared ? prepared->step() : std::nullopt;
  step = this->Check.Run.running() ? this->Check.Run.need() : step;
  this->DeviceButton = step ? step->button : "";
  return this->DeviceButton.c_str();
}

void vtkHapticSession::SetDeviceFile(const char* file)
{
  this->Impl->DeviceFile = file ? file : "";
}

void vtkHapticSession::PrepareDevice()
{
  if (this->Impl->Check.Run.running())
  {
    this->Impl->Check.Run.needDone(this->Impl->DeviceFile);
  }
  else if (const auto* const prepared = dynamic_cast<const palpate::PreparedDevice*>(this->Impl->Linked()))
  {
    prepared->stepDone(this->Impl->DeviceFile);
  }
}
