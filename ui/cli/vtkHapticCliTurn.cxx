// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticCliCommands.h"

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <thread>

#include "devices/DeviceFactory.h"
#include "devices/calibration/CalibrationFiles.h"
#include "devices/io/broker/DBusBroker.h"
#include "devices/line/LineRun.h"
#include "haptics/line/LineFile.h"
#include "vtkHapticCliOutput.h"
#include "vtkHapticCliProblem.h"

namespace
{
constexpr int RowEvery_ms = 10;
constexpr double Period_s = 1e-3;

palpate::LineWorld ReadWorld(const vtkHapticCliTurnOptions& options)
{
  constexpr std::streamsize mostRead = 64 << 20;
  std::ifstream file(options.File, std::ios::binary);
  std::string text(static_cast<std::size_t>(mostRead), '\0');
  if (!file || !file.read(text.data(), mostRead).eof())
  {
    throw vtkHapticCliProblem(options.File + (file ? ": longer than 64 MB" : ": cannot be read"));
  }
  text.resize(static_cast<std::size_t>(file.gcount()));
  auto parsed = palpate::parseLine(text);
  if (!parsed.problem.empty())
  {
    throw vtkHapticCliProblem(options.File + ": " + parsed.problem);
  }
  palpate::LineWorld world;
  world.places = std::move(parsed.value);
  palpate::scaleToHardest(world.places, options.Hardest_N);
  world.detentEvery_m = options.DetentEvery_m;
  world.detent_N = options.Detent_N;
  world.stop_N_per_m = options.Stop_N_per_m;
  return world;
}

/// A simulated hand turns from end to end, to and fro.
std::unique_ptr<palpate::HapticDevice> MakeDevice(
  const vtkHapticCliTurnOptions& options, const palpate::LineWorld& world)
{
  palpate::DeviceOptions wanted;
  wanted.hand = "light";
  wanted.wheel = true;
  wanted.calibrationFolder = palpate::userCalibrationFolder(std::getenv("XDG_CONFIG_HOME"), std::getenv("HOME"));
  wanted.stroke.points_D = { palpate::Vec3(world.places.front().s_m, 0.0, 0.0),
    palpate::Vec3(world.places.back().s_m, 0.0, 0.0) };
  palpate::MadeDevice made = palpate::makeDevice(options.Device, wanted);
  if (!made.device)
  {
    throw vtkHapticCliProblem(made.problem);
  }
  if (!made.warning.empty())
  {
    std::cerr << made.warning << '\n';
  }
  return std::move(made.device);
}

/// No hand is pushed before the person asks for it.
void AwaitPerson()
{
  std::cout << "Hold the device and press Enter: the force starts within 1 s; Ctrl-C ends the force." << std::endl;
  std::string line;
  if (!std::getline(std::cin, line))
  {
    throw vtkHapticCliProblem("Enter was not pressed, so there is no force");
  }
}

void Turn(palpate::LineRun& run, const vtkHapticCliTurnOptions& options, bool simulated, vtkHapticCliOutput* output)
{
  const auto rows = static_cast<long>(std::ceil(options.Seconds * 1000.0 / RowEvery_ms));
  for (long row = 1; row <= rows; ++row)
  {
    if (simulated)
    {
      run.step(RowEvery_ms);
    }
    else
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(RowEvery_ms));
    }
    if (output != nullptr)
    {
      output->Row({ static_cast<double>(row * RowEvery_ms) / 1000.0, run.state().s_m, run.state().force_N });
    }
    if (run.state().engage == palpate::EngageState::Fault)
    {
      throw vtkHapticCliProblem(options.Device + ": " + palpate::describe(run.state().fault));
    }
  }
}
} // namespace

int vtkHapticCliTurn(const vtkHapticCliTurnOptions& options)
{
  const palpate::LineWorld world = ReadWorld(options);
  std::unique_ptr<vtkHapticCliOutput> output;
  if (!options.Output.empty())
  {
    output = std::make_unique<vtkHapticCliOutput>(options.Output, std::vector<std::string>{ options.File });
    output->Header("t,s,force");
  }
  std::unique_ptr<palpate::HapticDevice> device = MakeDevice(options, world);
  const bool simulated = device->info().simulated;
  palpate::LineRun run;
  const std::string problem =
    run.start(std::move(device), world, {}, { Period_s, simulated, palpate::systemBrokers() });
  if (!problem.empty())
  {
    throw vtkHapticCliProblem(options.Device + ": " + problem);
  }
  if (!simulated)
  {
    AwaitPerson();
  }
  run.engage();
  Turn(run, options, simulated, output.get());
  run.stop();
  if (output)
  {
    output->Commit();
  }
  return 0;
}
