// SPDX-License-Identifier: GPL-3.0-or-later
// The part of vtkHapticSession that checks a device and keeps the result.
#include "vtkHapticDeviceCheck.h"

#include <algorithm>
#include <utility>

#include "devices/calibration/CalibrationFiles.h"
#include "devices/calibration/SelfTestFindings.h"
#include "devices/calibration/SelfTestText.h"
#include "devices/io/broker/DBusBroker.h"
#include "vtkHapticCheckState.h"
#include "vtkHapticSessionInternals.h"

void vtkHapticSession::Internals::FollowCheck()
{
  if (!this->Check.Run.running())
  {
    return;
  }
  if (this->Check.Run.state().verdict != palpate::SelfTestVerdict::None)
  {
    this->Check.Run.stop();
    this->TakeBackTrust();
  }
  const std::optional<palpate::DeviceStep> need = this->Check.Run.need();
  this->Check.Ask = need ? need->sentence : palpate::askOf(this->Check.Run.plan(), this->Check.Run.state());
  this->Check.Result = palpate::resultOf(this->Check.Run.plan(), this->Check.Run.state(), this->Check.Run.link());
}

void vtkHapticSession::Internals::TakeBackTrust()
{
  const palpate::HeldProof proof = palpate::heldProofOf(this->Check.Run.plan(), this->Check.Run.state());
  const palpate::DeviceInfo device = this->Check.Run.device();
  const std::string problem = palpate::takeBackTrust(this->CalibrationFolder, device.name, device.serial, proof);
  if (proof != palpate::HeldProof::Felt && this->Felt && this->Felt->device == device.name)
  {
    this->Felt->held = proof;
  }
  if (!problem.empty())
  {
    this->Problem = problem;
  }
  this->LookForDevices();
}

vtkSmartPointer<vtkHapticDeviceCheck> vtkHapticDeviceCheck::Of(vtkHapticSession& session)
{
  return vtkSmartPointer<vtkHapticDeviceCheck>::Take(new vtkHapticDeviceCheck(session));
}

void vtkHapticDeviceCheck::Start()
{
  auto& impl = this->Behind();
  if (this->Session->GetTouching())
  {
    this->Behind().Refuse("the device is in use; release the touch before a check");
    return;
  }
  impl.Check.Run.stop();
  impl.Check.Begun = false;
  palpate::DeviceOptions device = impl.Options();
  device.calibrationFolder.clear(); // the driver's own numbers, not those of a check before
  device.wheel = false;
  device.hand = "light";
  device.stroke.points_D = { palpate::Vec3::Zero() };
  palpate::MadeDevice made = palpate::makeDevice(impl.Chosen.name, device);
  std::string problem = made.problem;
  impl.Check.Twin = made.hasTwin;
  if (made.device)
  {
    palpate::SelfTestOptions options;
    options.period_s = vtkHapticSession::Internals::PeriodSeconds;
    options.virtualTime = impl.Settings.isOn("VirtualTime");
    options.deadMan = impl.Asked.asked().safety.deadMan;
    options.wheel = impl.Settings.isOn("Wheel");
    options.brokers = palpate::systemBrokers();
    problem = impl.Check.Run.start(std::move(made.device), options);
  }
  impl.Check.Begun = problem.empty();
  impl.Problem.clear();
  this->Behind().Refuse(problem);
  impl.Check.Ask.clear();
  impl.Check.Result.clear();
  impl.FollowCheck();
  this->Session->Modified();
}

void vtkHapticDeviceCheck::Stop()
{
  if (this->Behind().Check.Run.running())
  {
    this->Behind().Check.Run.stop();
    this->Behind().Check.Ask.clear();
    this->Behind().Check.Result = palpate::resultOf(
      this->Behind().Check.Run.plan(), this->Behind().Check.Run.state(), this->Behind().Check.Run.link());
    this->Session->Modified();
  }
}

int vtkHapticDeviceCheck::GetState() const
{
  if (!this->Behind().Check.Begun)
  {
    return CheckNone;
  }
  switch (this->Behind().Check.Run.state().verdict)
  {
    case palpate::SelfTestVerdict::Passed:
      return CheckPassed;
    case palpate::SelfTestVerdict::Faulty:
      return CheckFaulty;
    case palpate::SelfTestVerdict::Inconclusive:
      return CheckInconclusive;
    case palpate::SelfTestVerdict::Aborted:
      return CheckAborted;
    case palpate::SelfTestVerdict::None:
      break;
  }
  return CheckRuns;
}

double vtkHapticDeviceCheck::GetProgress() const
{
  return this->Behind().Check.Begun
           ? palpate::selfTestProgress(this->Behind().Check.Run.plan(), this->Behind().Check.Run.state())
           : 0.0;
}

const char* vtkHapticDeviceCheck::GetAsk() const
{
  return this->Behind().Check.Ask.c_str();
}

const char* vtkHapticDeviceCheck::GetResult() const
{
  return this->Behind().Check.Result.c_str();
}

void vtkHapticDeviceCheck::SetCalibrationFolder(const char* folder)
{
  const std::string wanted = folder ? folder : "";
  if (wanted != this->Behind().CalibrationFolder)
  {
    if (!std::exchange(this->Behind().CalibrationFolder, wanted).empty())
    {
      this->Behind().LookForDevices(); // without the results of the folder before
    }
    else
    {
      palpate::applyCalibrations(this->Behind().Known, wanted, this->Behind().Felt);
      this->Behind().LearnChosen();
    }
    this->Behind().JudgeStability();
    this->Session->Modified();
  }
}

const char* vtkHapticDeviceCheck::GetCalibrationFolder() const
{
  return this->Behind().CalibrationFolder.c_str();
}

bool vtkHapticDeviceCheck::KeepCalibration()
{
  auto& impl = this->Behind();
  const std::optional<palpate::Calibration> found =
    palpate::calibrationFrom(impl.Check.Run.plan(), impl.Check.Run.state(), impl.Check.Run.device(), palpate::today());
  const auto isTwin = [&](const palpate::KnownDevice& known) { return known.hasTwin && known.name == found->device; };
  const std::string problem = !found ? "there is no result to save: no device check has passed"
                              : impl.Check.Twin || std::any_of(impl.Known.begin(), impl.Known.end(), isTwin)
                                ? palpate::twinNote
                                : palpate::saveCalibration(impl.CalibrationFolder, *found);
  this->Behind().Refuse(problem);
  if (problem.empty())
  {
    impl.Felt = found->serial.empty() ? found : impl.Felt;
    impl.LookForDevices(); // the results of a check before are gone
    impl.JudgeStability();
    this->Session->Modified();
  }
  return problem.empty();
}
