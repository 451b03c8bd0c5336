// SPDX-License-Identifier: GPL-3.0-or-later
// The part of vtkHapticSession that checks a device and keeps what is found.
#include "vtkHapticSession.h"

#include <algorithm>
#include <utility>

#include "devices/calibration/CalibrationFiles.h"
#include "devices/calibration/SelfTestFindings.h"
#include "devices/calibration/SelfTestText.h"
#include "devices/io/broker/DBusBroker.h"
#include "vtkHapticSessionInternals.h"

void vtkHapticSession::Internals::FollowCheck()
{
  if (!this->Check.running())
  {
    return;
  }
  if (this->Check.state().verdict != palpate::SelfTestVerdict::None)
  {
    this->Check.stop();
    this->TakeBackTrust();
  }
  this->CheckAsk = palpate::askOf(this->Check.plan(), this->Check.state());
  this->CheckResult = palpate::resultOf(this->Check.plan(), this->Check.state(), this->Check.link());
}

void vtkHapticSession::Internals::TakeBackTrust()
{
  const palpate::HeldProof proof = palpate::heldProofOf(this->Check.plan(), this->Check.state());
  const palpate::DeviceInfo device = this->Check.device();
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

void vtkHapticSession::StartSelfTest()
{
  Internals& impl = *this->Impl;
  if (this->GetTouching())
  {
    this->Refuse("a device is checked only while it is not touching; let go first");
    return;
  }
  impl.Check.stop();
  impl.Checked = false;
  palpate::DeviceOptions device = impl.Options();
  device.calibrationFolder.clear(); // what the driver says, not what was found before
  device.wheel = false;
  device.hand = "light";
  device.stroke.points_D = { palpate::Vec3::Zero() };
  palpate::MadeDevice made = palpate::makeDevice(impl.Chosen.name, device);
  std::string problem = made.problem;
  impl.CheckedTwin = made.hasTwin;
  if (made.device)
  {
    palpate::SelfTestOptions options;
    options.period_s = Internals::PeriodSeconds;
    options.virtualTime = impl.VirtualTime;
    options.deadMan = impl.Asked.asked().safety.deadMan;
    options.wheel = impl.Wheel;
    options.brokers = palpate::systemBrokers();
    problem = impl.Check.start(std::move(made.device), options);
  }
  impl.Checked = problem.empty();
  impl.Problem.clear();
  this->Refuse(problem);
  impl.CheckAsk.clear();
  impl.CheckResult.clear();
  impl.FollowCheck();
  this->Modified();
}

void vtkHapticSession::StopSelfTest()
{
  if (this->Impl->Check.running())
  {
    this->Impl->Check.stop();
    this->Impl->CheckAsk.clear();
    this->Impl->CheckResult =
      palpate::resultOf(this->Impl->Check.plan(), this->Impl->Check.state(), this->Impl->Check.link());
    this->Modified();
  }
}

int vtkHapticSession::GetSelfTestState() const
{
  if (!this->Impl->Checked)
  {
    return CheckNone;
  }
  switch (this->Impl->Check.state().verdict)
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

double vtkHapticSession::GetSelfTestProgress() const
{
  return this->Impl->Checked ? palpate::selfTestProgress(this->Impl->Check.plan(), this->Impl->Check.state()) : 0.0;
}

const char* vtkHapticSession::GetSelfTestAsk() const
{
  return this->Impl->CheckAsk.c_str();
}

const char* vtkHapticSession::GetSelfTestResult() const
{
  return this->Impl->CheckResult.c_str();
}

void vtkHapticSession::SetCalibrationFolder(const char* folder)
{
  const std::string wanted = folder ? folder : "";
  if (wanted != this->Impl->CalibrationFolder)
  {
    if (!std::exchange(this->Impl->CalibrationFolder, wanted).empty())
    {
      this->Impl->LookForDevices(); // without what the folder before said of them
    }
    else
    {
      palpate::applyCalibrations(this->Impl->Known, wanted, this->Impl->Felt);
      this->Impl->LearnChosen();
    }
    this->Impl->JudgeStability();
    this->Modified();
  }
}

const char* vtkHapticSession::GetCalibrationFolder() const
{
  return this->Impl->CalibrationFolder.c_str();
}

bool vtkHapticSession::KeepCalibration()
{
  Internals& impl = *this->Impl;
  const std::optional<palpate::Calibration> found =
    palpate::calibrationFrom(impl.Check.plan(), impl.Check.state(), impl.Check.device(), palpate::today());
  const auto isTwin = [&](const palpate::KnownDevice& known) { return known.hasTwin && known.name == found->device; };
  const std::string problem = !found ? "there is nothing to keep: no check of a device has passed"
                              : impl.CheckedTwin || std::any_of(impl.Known.begin(), impl.Known.end(), isTwin)
                                ? palpate::twinNote
                                : palpate::saveCalibration(impl.CalibrationFolder, *found);
  this->Refuse(problem);
  if (problem.empty())
  {
    impl.Felt = found->serial.empty() ? found : impl.Felt;
    impl.LookForDevices(); // what was known of it before is gone
    impl.JudgeStability();
    this->Modified();
  }
  return problem.empty();
}
