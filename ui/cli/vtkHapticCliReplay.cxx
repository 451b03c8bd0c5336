// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticCliCommands.h"

#include <algorithm>
#include <iostream>
#include <limits>
#include <optional>
#include <thread>

#include "haptics/recording/Recording.h"
#include "haptics/session/mechanism/MechanismTouch.h"
#include "haptics/session/path/PathRunner.h"
#include "haptics/session/path/TickCost.h"
#include "vtkHapticCliOutput.h"
#include "vtkHapticCliProblem.h"
#include "vtkHapticCliScene.h"
#include "vtkHapticFileGuards.h"
#include "vtkHapticReaders.h"

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
  vtkHapticCliCheckIsoIsUsed(options.Scenes, options.Iso);
  std::vector<palpate::SurfaceInput> inputs;
  for (const std::string& file : options.Scenes)
  {
    std::string none;
    const std::optional<double> iso = vtkHapticIsImageFile(file) ? options.Iso : std::nullopt;
    inputs.push_back(*palpate::sceneInput(vtkHapticCliReadSurface(file, iso).front(), palpate::pathSettings(), none));
  }
  scenes.push_back(vtkHapticCliBuild(inputs));
  for (std::size_t i = 0; options.Scenes.size() > 1 && i < options.Scenes.size(); ++i)
  {
    scenes.push_back(std::make_shared<const palpate::Scene>(
      scenes.front()->revision(), std::vector<palpate::Surface>{ scenes.front()->surfaces()[i] }));
  }
  return scenes;
}

/// A recording numbers constraints, and has their kinds and no names.
std::string NumberedConstraint(int law)
{
  return "law" + std::to_string(law + 1);
}

/// Of the mechanism with most constraints.
int ConstraintsOf(const palpate::Recording& recording)
{
  int most = 0;
  for (const palpate::RecordedMechanism& mechanism : recording.mechanisms)
  {
    most = std::max(most, mechanism.plan.lawCount);
  }
  return most;
}

std::string ConstraintColumns(int laws)
{
  std::string columns;
  for (int law = 0; law < laws; ++law)
  {
    for (const char* what : { "_force", "_phase", "_inside" })
    {
      columns += "," + NumberedConstraint(law) + what;
    }
  }
  return columns;
}

/// Tells which constraints change, as the ticks are recomputed.
class ChangedConstraints
{
public:
  explicit ChangedConstraints(const palpate::Recording& recording) : Recording(recording) {}

  /// Changes before a recording began are not told.
  void Add(const palpate::HapticState& state)
  {
    const palpate::ConstraintChanges& now = state.mechanism.changes;
    const std::uint64_t kept = std::min<std::uint64_t>(now.count, now.newest.size());
    const std::uint64_t told = this->Before && this->Before->plan == now.plan ? this->Before->count : 0;
    for (std::uint64_t i = std::max(told, now.count - kept); this->Before && i < now.count; ++i)
    {
      this->Tell(state, now.at(i));
    }
    this->Before = now;
  }

private:
  void Tell(const palpate::HapticState& state, const palpate::MechanismEvent& event) const
  {
    const auto isIt = [&state](const auto& mechanism) { return mechanism.plan.revision == state.mechanism.revision; };
    const auto& all = this->Recording.mechanisms;
    const auto found = std::find_if(all.begin(), all.end(), isIt);
    const std::string kind =
      found != all.end() ? std::string(" (") + palpate::nameOf(found->plan.laws[event.law].kind) + ")" : "";
    std::cerr << "palpate: " << state.time_s << " s: tick " << event.tick << ": "
              << NumberedConstraint(static_cast<int>(event.law)) << kind << ' ' << palpate::wordsOf(event.change)
              << " at " << event.force_N << " N\n";
  }

  const palpate::Recording& Recording;
  std::optional<palpate::ConstraintChanges> Before; ///< of the tick before
};

/// Writes the ticks as they are recomputed. Before the first one there is no tick, so its cost is not known.
class TickTable
{
public:
  TickTable(const vtkHapticCliReplayOptions& options, int laws)
    : Output(options.Output, Inputs(options)), Constraints(static_cast<std::size_t>(laws))
  {
    this->Output.Header(vtkHapticCliOutput::TickColumns + ConstraintColumns(laws));
  }

  void Add(const palpate::TickOutput& tick)
  {
    const double cost_us = this->Started ? this->Cost.cost_us() : std::numeric_limits<double>::quiet_NaN();
    const palpate::HapticState& state = tick.state;
    const palpate::Vec3 &device_W = state.device_W.p, &proxy_W = state.proxy_W.p, &force_W = state.force_W;
    std::vector<double> values{ state.time_s, device_W.x(), device_W.y(), device_W.z(), proxy_W.x(), proxy_W.y(),
      proxy_W.z(), force_W.x(), force_W.y(), force_W.z(), static_cast<double>(state.contacts), cost_us };
    for (std::size_t i = 0; i < this->Constraints; ++i)
    {
      const palpate::ConstraintReport& law = state.mechanism.laws[i];
      values.insert(values.end(), { law.force_N, static_cast<double>(law.phase), law.inside_u });
    }
    this->Output.Row(values);
    this->Started = true;
    this->Cost.start();
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
  std::size_t Constraints;
  palpate::TickCost Cost;
  bool Started = false;
};
} // namespace

int vtkHapticCliReplay(const vtkHapticCliReplayOptions& options)
{
  const palpate::Recording recording = Read(options.Recording);
  const std::vector<std::shared_ptr<const palpate::Scene>> scenes = ScenesOf(options);
  std::optional<TickTable> table;
  if (!options.Output.empty())
  {
    table.emplace(options, ConstraintsOf(recording));
  }
  ChangedConstraints changed(recording);
  std::function<void(const palpate::TickOutput&)> visit;
  if (table || !recording.mechanisms.empty())
  {
    visit = [&](const palpate::TickOutput& tick)
    {
      changed.Add(tick.state);
      if (table)
      {
        table->Add(tick);
      }
    };
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
