// SPDX-License-Identifier: GPL-3.0-or-later
// Labyrinths played from a device alone: no mouse, no display. The output is for persons who stand beside.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <thread>

#include "devices/DeviceFactory.h"
#include "devices/calibration/CalibrationFiles.h"
#include "devices/io/broker/DBusBroker.h"
#include "devices/simulated/labyrinth/LabyrinthPlayer.h"
#include "haptics/core/Text.h"
#include "haptics/session/HapticSession.h"
#include "vtkHapticCliCommands.h"
#include "vtkHapticCliProblem.h"
#include "vtkHapticCliScene.h"

namespace
{
constexpr int NobodyArrived = 1;
volatile std::sig_atomic_t Interrupted = 0;

extern "C" void Interrupt(int)
{
  Interrupted = 1;
}

/// The one device that pushes a hand and can be used now.
std::string PluggedIn(const palpate::DeviceOptions& wanted)
{
  std::string usable, others;
  int count = 0;
  for (const palpate::KnownDevice& known : palpate::knownDevices(wanted))
  {
    if (known.info.simulated || (known.problem.empty() && !known.info.rendersForce))
    {
      continue;
    }
    if (!known.problem.empty())
    {
      others += "; " + known.name + ": " + known.problem;
      continue;
    }
    usable += (count++ > 0 ? ", " : "") + known.name;
  }
  if (count == 0)
  {
    throw vtkHapticCliProblem("no force-feedback device is attached: attach one, or try --device simulated-joystick, "
                              "which a simulated hand plays" +
                              others);
  }
  if (count > 1)
  {
    throw vtkHapticCliProblem("several devices are attached; choose one with --device: " + usable);
  }
  return usable;
}

palpate::DeadMan DeadManOf(const std::string& hold)
{
  if (hold.empty() || hold == "grip")
  {
    return { 0, !hold.empty() };
  }
  const int button = palpate::numberIn<int>(hold).value_or(0);
  if (button < 1 || button > 32)
  {
    throw vtkHapticCliProblem("--hold " + hold + ": must be the number of a button, 1 to 32, or grip");
  }
  return { 1u << (button - 1), false };
}

/// A button cannot both hold and choose.
void CheckHold(const palpate::DeadMan& deadMan, std::size_t labyrinths)
{
  const int choose = static_cast<int>(labyrinths) + 1; // with the one that ends
  if (deadMan.buttons != 0 && deadMan.buttons < (1u << std::min(choose, 31)))
  {
    throw vtkHapticCliProblem(
      "--hold: buttons 1 to " + std::to_string(choose) +
      " choose a labyrinth; use a button above these, the grip, or omit --hold to hold the button that chose");
  }
}

/// A device that cannot be played with is refused before it is opened.
void CheckDevice(const std::string& name, const palpate::DeadMan& deadMan, const palpate::DeviceOptions& wanted)
{
  for (const palpate::KnownDevice& known : palpate::knownDevices(wanted))
  {
    if (known.name != name)
    {
      continue;
    }
    if (known.problem.empty() && !known.info.rendersForce)
    {
      throw vtkHapticCliProblem(name + " renders no force, so that walls cannot be felt; choose another --device");
    }
    if (known.problem.empty() && known.info.abilities.sensedAxes < 2)
    {
      throw vtkHapticCliProblem(name + " moves along one line, but a labyrinth needs a plane; choose another --device");
    }
    if (deadMan.grip && !known.hasGrip)
    {
      throw vtkHapticCliProblem("--hold grip: " + name + ": " + palpate::noGripNote);
    }
  }
}

std::unique_ptr<palpate::HapticDevice> Open(
  const std::string& name, const palpate::DeadMan& deadMan, palpate::DeviceOptions wanted)
{
  CheckDevice(name, deadMan, wanted);
  if (!palpate::deviceModel(name)) // nothing was found out about a simulated one
  {
    wanted.calibrationFolder = palpate::userCalibrationFolder(std::getenv("XDG_CONFIG_HOME"), std::getenv("HOME"));
  }
  palpate::MadeDevice made = palpate::makeDevice(name, wanted);
  if (!made.device)
  {
    throw vtkHapticCliProblem(made.problem);
  }
  if (!made.warning.empty())
  {
    std::cerr << "palpate: " << name << ": " << made.warning << '\n';
  }
  return std::move(made.device);
}

std::vector<palpate::LabyrinthOnOffer> Offer(std::vector<palpate::Labyrinth> labyrinths)
{
  std::vector<palpate::LabyrinthOnOffer> offer;
  for (palpate::Labyrinth& labyrinth : labyrinths)
  {
    std::shared_ptr<const palpate::Scene> walls = vtkHapticCliBuild({ palpate::wallsOf(labyrinth) });
    offer.push_back({ std::move(labyrinth), std::move(walls) });
  }
  return offer;
}

std::string WhatHolds(const palpate::DeadMan& deadMan)
{
  if (deadMan.grip)
  {
    return "the grip";
  }
  std::ostringstream text;
  for (int button = 1; button <= 32; ++button)
  {
    (deadMan.buttons >> (button - 1) & 1u) != 0 ? text << "button " << button : text;
  }
  return text.str();
}

void Welcome(
  const std::string& device, const std::vector<palpate::LabyrinthOnOffer>& offer, const palpate::DeadMan& deadMan)
{
  std::cout << device << ": press";
  for (std::size_t i = 0; i < offer.size(); ++i)
  {
    std::cout << (i > 0 ? ", " : " ") << i + 1 << " for " << offer[i].labyrinth.name;
  }
  std::cout << "; " << offer.size() + 1 << " ends, Ctrl-C too.\n";
  if (deadMan == palpate::DeadMan{})
  {
    std::cout << "Keep the button pressed while you play; releasing it gives up." << std::endl;
    return;
  }
  std::cout << "Hold " << WhatHolds(deadMan) << " while you play; any other button pressed for "
            << palpate::LabyrinthMenu::giveUp_s << " s gives up." << std::endl;
}

/// Reports an event. True when the game is over.
bool Tell(palpate::LabyrinthNews news, const palpate::LabyrinthHost& host, palpate::Fault fault, int& arrived)
{
  if (news == palpate::LabyrinthNews::Fault)
  {
    std::cout << palpate::describe(fault) << std::endl;
  }
  if (news == palpate::LabyrinthNews::None || news == palpate::LabyrinthNews::Fault ||
      news == palpate::LabyrinthNews::End)
  {
    return news == palpate::LabyrinthNews::End;
  }
  std::cout << host.chosen()->name << ": ";
  switch (news)
  {
    case palpate::LabyrinthNews::Chosen:
      std::cout << "hold " << WhatHolds(host.held());
      break;
    case palpate::LabyrinthNews::Leads:
      std::cout << "the device guides your hand to the start";
      break;
    case palpate::LabyrinthNews::LetGo:
      std::cout << "find the exit by touch";
      break;
    case palpate::LabyrinthNews::Arrived:
      ++arrived;
      std::cout << "arrived after " << host.time_s() << " s";
      break;
    default:
      std::cout << "given up";
  }
  std::cout << std::endl;
  return false;
}

int Played(palpate::HapticSession& session, int arrived)
{
  session.stop();
  std::cout << (arrived == 1 ? "1 arrival" : std::to_string(arrived) + " arrivals") << '\n';
  return arrived > 0 ? 0 : NobodyArrived;
}

int PlayByHand(palpate::HapticSession& session, palpate::LabyrinthHost& host)
{
  constexpr auto pause = std::chrono::milliseconds(10);
  std::signal(SIGINT, Interrupt);
  std::signal(SIGTERM, Interrupt);
  int arrived = 0;
  while (Interrupted == 0 && !Tell(host.look(), host, session.state().fault, arrived))
  {
    std::this_thread::sleep_for(pause);
  }
  return Played(session, arrived);
}

/// A simulated hand plays each of them, in virtual time.
int PlaySimulated(palpate::HapticSession& session, palpate::LabyrinthHost& host, palpate::LabyrinthPlayer& player)
{
  int arrived = 0;
  while (!Tell(host.look(), host, session.state().fault, arrived))
  {
    session.step(1);
    player.look(session.state(), session.parameters().map);
  }
  return Played(session, arrived);
}

palpate::HapticParameters ParametersFor(const palpate::DeviceInfo& info)
{
  palpate::HapticParameters parameters;
  parameters.walls.hold = true;                        // where the device can
  parameters.guide.on = info.abilities.sensedAxes > 2; // a hand in space is led to the plane
  parameters.passivity.enabled = true;
  parameters.safety = palpate::SafetyLimits::forDevice(info);
  return parameters;
}
} // namespace

int vtkHapticCliPlay(std::vector<palpate::Labyrinth> labyrinths, const vtkHapticCliLabyrinthOptions& options)
{
  const palpate::DeadMan deadMan = DeadManOf(options.Hold);
  CheckHold(deadMan, labyrinths.size());
  palpate::DeviceOptions wanted;
  wanted.hand = "firm";
  wanted.stroke.points_D = { palpate::Vec3::Zero() };
  const std::string name = options.Device.empty() ? PluggedIn(wanted) : options.Device;
  std::unique_ptr<palpate::HapticDevice> device = Open(name, deadMan, wanted);
  auto* const simulated = dynamic_cast<palpate::SimulatedDevice*>(device.get());
  const std::vector<palpate::LabyrinthOnOffer> offer = Offer(std::move(labyrinths));
  palpate::SessionOptions how;
  how.virtualTime = simulated != nullptr;
  how.engage = false;
  how.brokers = palpate::systemBrokers();
  palpate::HapticSession session;
  const palpate::HapticParameters parameters = ParametersFor(device->info());
  for (const std::string& problem : { session.setParameters(parameters), session.start(std::move(device), how) })
  {
    if (!problem.empty())
    {
      throw vtkHapticCliProblem(name + ": " + problem);
    }
  }
  Welcome(name, offer, deadMan);
  palpate::LabyrinthHost host(session, offer, deadMan);
  if (simulated == nullptr)
  {
    return PlayByHand(session, host);
  }
  palpate::LabyrinthRun run;
  run.device = *palpate::deviceModel(name);
  palpate::LabyrinthPlayer player(*simulated, run, offer, deadMan);
  return PlaySimulated(session, host, player);
}
