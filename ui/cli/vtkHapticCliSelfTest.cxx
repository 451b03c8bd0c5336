// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticCliCommands.h"

#include "devices/DeviceFactory.h"
#include "devices/calibration/CalibrationFiles.h"
#include "devices/calibration/SelfTestFindings.h"
#include "devices/calibration/SelfTestRun.h"
#include "devices/calibration/SelfTestText.h"
#include "devices/io/broker/DBusBroker.h"
#include "vtkHapticCliProblem.h"

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <thread>

namespace
{
/// The steps that the device needs first: a person does each and confirms it.
class Steps
{
public:
  explicit Steps(palpate::SelfTestRun& run) : Run(run) {}

  /// Asks for the step that is due now. A step that was confirmed and did not succeed is asked for again.
  void Follow()
  {
    const std::optional<palpate::DeviceStep> need = this->Run.need();
    const bool confirmed = need && need->sentence == this->Asked && !need->button.empty();
    if (need && (need->sentence != this->Asked || (confirmed && Clock::now() - this->At > Takes)))
    {
      this->Ask(*need);
      this->Asked = need->sentence;
      this->At = Clock::now();
    }
  }

private:
  using Clock = std::chrono::steady_clock;
  static constexpr auto Takes = std::chrono::seconds(5); ///< longer than a firmware takes to load

  void Ask(const palpate::DeviceStep& need)
  {
    std::cout << need.sentence << std::endl;
    if (need.button.empty())
    {
      return;
    }
    std::cout << (need.wantsFile ? "Type the name of the file" : need.button + ": press Enter") << std::endl;
    std::string line;
    if (!std::getline(std::cin, line))
    {
      throw vtkHapticCliProblem("the check needs an answer, and the input has ended: run the check in a terminal");
    }
    this->Run.needDone(line);
  }

  palpate::SelfTestRun& Run;
  std::string Asked;
  Clock::time_point At;
};

/// Until there is a verdict; the person who holds the device reads the instructions. A simulated hand needs no time of
/// ours.
void Follow(palpate::SelfTestRun& run, bool simulated)
{
  constexpr int ticksAtOnce = 100;
  constexpr auto pause = std::chrono::milliseconds(20);
  std::string said;
  Steps steps(run);
  while (run.state().verdict == palpate::SelfTestVerdict::None)
  {
    steps.Follow();
    const std::string ask = palpate::askOf(run.plan(), run.state());
    if (ask != said)
    {
      said = ask;
      std::cout << ask << std::endl; // now, not when the buffer is full
    }
    if (simulated)
    {
      run.step(ticksAtOnce);
    }
    else
    {
      std::this_thread::sleep_for(pause);
    }
  }
  run.stop();
}

/// The folder for the result, asked for before a person has worked for it.
std::string FolderToKeepIn()
{
  const std::string folder = palpate::userCalibrationFolder(std::getenv("XDG_CONFIG_HOME"), std::getenv("HOME"));
  if (folder.empty())
  {
    throw vtkHapticCliProblem("--keep: no folder for the result: neither XDG_CONFIG_HOME nor HOME is an absolute path");
  }
  return folder;
}

/// A check that felt a fault in walls that the device holds ends the trust in them, kept or not.
void TakeBackTrust(palpate::SelfTestRun& run)
{
  const std::string folder = palpate::userCalibrationFolder(std::getenv("XDG_CONFIG_HOME"), std::getenv("HOME"));
  const palpate::DeviceInfo device = run.device();
  const std::string problem =
    palpate::takeBackTrust(folder, device.name, device.serial, palpate::heldProofOf(run.plan(), run.state()));
  if (!problem.empty())
  {
    throw vtkHapticCliProblem(problem);
  }
}

void Keep(const palpate::Calibration& calibration, const std::string& folder)
{
  const std::string problem = palpate::saveCalibration(folder, calibration);
  if (!problem.empty())
  {
    throw vtkHapticCliProblem(problem);
  }
  std::cout << "kept in " << palpate::calibrationFile(folder, calibration.device, calibration.serial) << '\n';
  if (calibration.serial.empty() && calibration.held == palpate::HeldProof::Felt)
  {
    std::cout << "not kept: the measured walls, because the device has no serial number to identify it\n";
  }
}
} // namespace

int vtkHapticCliSelfTest(const std::string& device, bool keep, bool wheel)
{
  const std::string folder = keep ? FolderToKeepIn() : "";
  palpate::DeviceOptions wanted;
  wanted.hand = "light";
  wanted.stroke.points_D = { palpate::Vec3::Zero() };
  palpate::MadeDevice made = palpate::makeDevice(device, wanted);
  if (!made.device)
  {
    throw vtkHapticCliProblem(made.problem);
  }
  if (keep && made.hasTwin)
  {
    throw vtkHapticCliProblem("--keep: " + device + ": " + palpate::twinNote);
  }
  palpate::SelfTestOptions options;
  options.virtualTime = made.device->info().simulated;
  options.wheel = wheel;
  options.brokers = palpate::systemBrokers();
  palpate::SelfTestRun run;
  const std::string problem = run.start(std::move(made.device), options);
  if (!problem.empty())
  {
    throw vtkHapticCliProblem(device + ": " + problem);
  }
  Follow(run, options.virtualTime);
  std::cout << palpate::resultOf(run.plan(), run.state(), run.link()) << '\n';
  const std::optional<palpate::Calibration> found =
    palpate::calibrationFrom(run.plan(), run.state(), run.device(), palpate::today());
  if (found && keep)
  {
    Keep(*found, folder);
  }
  else
  {
    TakeBackTrust(run);
  }
  return found ? 0 : 1;
}
