// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticCliCommands.h"

#include <iostream>
#include <limits>
#include <optional>
#include <thread>

#include "haptics/recording/Recording.h"
#include "vtkHapticCliOutput.h"
#include "vtkHapticCliProblem.h"
#include "vtkHapticCliScene.h"
#include "vtkHapticCliTicks.h"
#include "vtkHapticFileGuards.h"

namespace
{
palpate::Recording Read(const std::string& file)
{
  if (const std::string problem = vtkHapticFileGuards::CheckFile(file); !problem.empty())
  {
    throw vtkHapticCliProblem(file + ": " + problem);
  }
  std::variant<palpate::Recording, std::string> read = palpate::readRecording(file);
  if (const auto* problem = std::get_if<std::string>(&read))
  {
    throw vtkHapticCliProblem(*problem);
  }
  return std::get<palpate::Recording>(std::move(read));
}

/// All files as one scene, and each by itself: a recording may hold several scenes and finds its own by their content.
std::vector<std::shared_ptr<const palpate::Scene>> ScenesOf(const vtkHapticCliReplayOptions& options)
{
  std::vector<std::shared_ptr<const palpate::Scene>> scenes;
  if (options.Scenes.empty())
  {
    return scenes;
  }
  scenes.push_back(vtkHapticCliBuildScene(options.Scenes, options.Iso));
  for (std::size_t i = 0; options.Scenes.size() > 1 && i < options.Scenes.size(); ++i)
  {
    scenes.push_back(std::make_shared<const palpate::Scene>(
      scenes.front()->revision(), std::vector<palpate::Surface>{ scenes.front()->surfaces()[i] }));
  }
  return scenes;
}

/// Writes the ticks as they are recomputed. What precedes the first one is no tick, so its cost is not known.
class TickTable
{
public:
  explicit TickTable(const vtkHapticCliReplayOptions& options) : Output(options.Output, Inputs(options))
  {
    vtkHapticCliWriteHeader(this->Output);
  }

  void Add(const palpate::TickOutput& tick)
  {
    const double cost_us = this->Started ? this->Stopwatch.Cost_us() : std::numeric_limits<double>::quiet_NaN();
    vtkHapticCliWriteTick(this->Output, tick.state.time_s, tick.state, cost_us);
    this->Started = true;
    this->Stopwatch.Start();
  }

  void Commit() { this->Output.Commit(); }

private:
  static std::vector<std::string> Inputs(const vtkHapticCliReplayOptions& options)
  {
    std::vector<std::string> inputs = options.Scenes;
    inputs.push_back(options.Recording);
    return inputs;
  }

  vtkHapticCliOutput Output;
  vtkHapticCliStopwatch Stopwatch;
  bool Started = false;
};
} // namespace

int vtkHapticCliReplay(const vtkHapticCliReplayOptions& options)
{
  const palpate::Recording recording = Read(options.Recording);
  if (const std::string skipped = recording.skipped.describe(); !skipped.empty())
  {
    std::cerr << options.Recording << ": " << skipped << '\n';
  }
  const std::vector<std::shared_ptr<const palpate::Scene>> scenes = ScenesOf(options);
  std::optional<TickTable> table;
  std::function<void(const palpate::TickOutput&)> visit;
  if (!options.Output.empty())
  {
    table.emplace(options);
    visit = [&table](const palpate::TickOutput& tick) { table->Add(tick); };
  }
  const palpate::ReplayResult result = palpate::replay(recording, scenes, std::thread::hardware_concurrency(), visit);
  if (!result.problem.empty())
  {
    throw vtkHapticCliProblem(options.Recording + ": " + result.problem);
  }
  if (table)
  {
    table->Commit();
  }
  if (!result.difference.empty())
  {
    std::cout << options.Recording << ": " << result.difference << '\n';
    return 1;
  }
  std::cout << options.Recording << ": " << result.ticks << " ticks computed again, every bit as recorded\n";
  return 0;
}
