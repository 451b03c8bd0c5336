// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <iostream>

#include "devices/simulated/labyrinth/LabyrinthRun.h"
#include "haptics/session/path/PathTouch.h"
#include "vtkHapticCliCommands.h"
#include "vtkHapticCliOutput.h"
#include "vtkHapticCliPath.h"
#include "vtkHapticCliProblem.h"
#include "vtkHapticCliScene.h"
#include "vtkHapticGallery.h"
#include "vtkHapticLabyrinthData.h"

namespace
{
constexpr int NotArrived = 1;

palpate::Labyrinth Read(const std::string& nameOrFile, std::optional<double> corridor_u)
{
  const vtkHapticLabyrinthResult read = vtkHapticReadLabyrinth(vtkHapticGallery::FileOf(nameOrFile), corridor_u);
  if (!read.Problem.empty())
  {
    throw vtkHapticCliProblem(read.Problem);
  }
  vtkHapticCliNote(nameOrFile, read.Note);
  return read.Labyrinth;
}

void Describe(const palpate::Labyrinth& labyrinth)
{
  const bool maze = labyrinth.start_W && labyrinth.exit_W;
  const palpate::PlaneBox box = palpate::fence(labyrinth);
  const Eigen::Vector2d size = box.high_W - box.low_W;
  std::cout << labyrinth.name << ": " << (maze ? "a maze" : "a structure to explore") << " of "
            << labyrinth.curves.segments.size() << " segments, " << size.x() << " by " << size.y()
            << " u, corridors of " << labyrinth.corridor_u << " u\n";
  if (maze)
  {
    const Eigen::Vector2d& a = *labyrinth.start_W;
    const Eigen::Vector2d& b = *labyrinth.exit_W;
    std::cout << "  from (" << a.x() << ", " << a.y() << ") to (" << b.x() << ", " << b.y() << ") u\n";
  }
}

std::vector<std::string> GalleryNames()
{
  const std::vector<std::string> names = vtkHapticGallery::Names();
  if (names.empty())
  {
    throw vtkHapticCliProblem("there is no gallery beside this program (share/palpate/gallery); give a file");
  }
  return names;
}

int List()
{
  for (const std::string& name : GalleryNames())
  {
    palpate::Labyrinth labyrinth = Read(name, std::nullopt);
    labyrinth.name = name;
    Describe(labyrinth);
  }
  return 0;
}

class Trace
{
public:
  Trace(const std::string& file, const std::vector<std::string>& inputs)
  {
    if (!file.empty())
    {
      this->Output.emplace(file, inputs);
      this->Output->Header("t,x,y,hand_x,hand_y,force");
    }
  }

  void Row(const palpate::LabyrinthMoment& moment)
  {
    if (this->Output)
    {
      this->Output->Row({ moment.time_s, moment.location_W.x(), moment.location_W.y(), moment.hand_W.x(),
        moment.hand_W.y(), moment.force_N });
    }
  }

  void Commit()
  {
    if (this->Output)
    {
      this->Output->Commit();
    }
  }

private:
  std::optional<vtkHapticCliOutput> Output;
};

palpate::LabyrinthRun RunOf(const vtkHapticCliLabyrinthOptions& options)
{
  const std::string device = options.Device.empty() ? "simulated-joystick" : options.Device;
  const palpate::DeviceModel* const model = palpate::deviceModel(device);
  if (!model)
  {
    throw vtkHapticCliProblem("--device " + device + ": no simulated device has that name (palpate devices)");
  }
  if (options.DeviceWalls && model->loop_s == 0.0)
  {
    throw vtkHapticCliProblem(
      "--device-walls: " + device + " cannot hold walls in a loop of its own; omit --device-walls");
  }
  palpate::LabyrinthRun run;
  run.device = *model;
  run.host_Hz = options.Host_Hz;
  run.deviceHoldsWalls = options.DeviceWalls;
  run.trace = !options.Output.empty();
  return run;
}

int Solve(const palpate::Labyrinth& labyrinth, const vtkHapticCliLabyrinthOptions& options)
{
  const palpate::LabyrinthRun run = RunOf(options);
  if (const std::string problem = palpate::refuse(labyrinth, run); !problem.empty())
  {
    throw vtkHapticCliProblem(labyrinth.name + ": " + problem);
  }
  Trace trace(options.Output, { labyrinth.name });
  const palpate::LabyrinthOutcome outcome = palpate::runBlind(labyrinth, run);
  for (const palpate::LabyrinthMoment& moment : outcome.trace)
  {
    trace.Row(moment);
  }
  trace.Commit();
  std::cout << labyrinth.name << ": " << (outcome.problem.empty() ? "arrived" : outcome.problem);
  if (outcome.explored)
  {
    std::cout << " after " << outcome.time_s << " s, a path of " << outcome.way_u << " u and " << outcome.places
              << " places; " << outcome.lead_s << " s to the start before";
  }
  std::cout << "\n";
  return outcome.problem.empty() ? 0 : NotArrived;
}

/// The labyrinths to play: of the gallery all that have a start and an exit, or the one that was given.
std::vector<palpate::Labyrinth> ToPlay(const vtkHapticCliLabyrinthOptions& options)
{
  std::vector<palpate::Labyrinth> labyrinths;
  if (!options.File.empty())
  {
    labyrinths.push_back(Read(options.File, options.Corridor_u));
    if (const std::string problem = palpate::refuse(labyrinths.back()); !problem.empty())
    {
      throw vtkHapticCliProblem(problem);
    }
    labyrinths.back().name = options.File;
    return labyrinths;
  }
  for (const std::string& name : GalleryNames())
  {
    palpate::Labyrinth labyrinth = Read(name, std::nullopt);
    labyrinth.name = name;
    if (palpate::refuse(labyrinth).empty())
    {
      labyrinths.push_back(std::move(labyrinth));
    }
  }
  return labyrinths;
}

/// An option that changes nothing is a mistake somebody would like to hear of.
void CheckOptions(const vtkHapticCliLabyrinthOptions& options)
{
  const auto needs = [](bool given, const char* option, bool there, const char* what)
  {
    if (given && !there)
    {
      throw vtkHapticCliProblem(std::string(option) + " needs " + what);
    }
  };
  const vtkHapticCliLabyrinthOptions unasked;
  const bool moves = options.Solve || !options.Path.empty();
  needs(options.Solve, "--solve", !options.File.empty(), "a labyrinth: a file, or a name of the gallery");
  needs(!options.Path.empty(), "--path", !options.File.empty(), "a labyrinth: a file, or a name of the gallery");
  needs(options.Corridor_u.has_value(), "--corridor", !options.File.empty(),
    "a labyrinth: a file, or a name of the gallery");
  needs(!options.Output.empty(), "--csv", moves, "a hand that moves: --solve or --path");
  needs(
    !options.Device.empty(), "--device", options.Solve || options.Play, "--solve or --play: a path needs no device");
  needs(!options.Hold.empty(), "--hold", options.Play, "--play: no other mode has a dead-man switch");
  needs(options.Host_Hz != unasked.Host_Hz, "--host", options.Solve, "--solve: a path needs no device");
  needs(options.DeviceWalls, "--device-walls", options.Solve, "--solve: a path needs no device");
}

/// The hand is where the path says, the disc where the walls let it.
int Follow(const palpate::Labyrinth& labyrinth, const vtkHapticCliLabyrinthOptions& options)
{
  const std::vector<palpate::PathSample> path = vtkHapticCliReadPath(options.Path);
  vtkHapticCliCheckPlanePath(options.Path, path);
  const std::shared_ptr<const palpate::Scene> scene = vtkHapticCliBuild({ palpate::wallsOf(labyrinth) });
  Trace trace(options.Output, { labyrinth.name, options.Path });
  palpate::HapticParameters parameters;
  parameters.contact.radius_u = labyrinth.radius_u();
  constexpr double firstTick_s = 1e-3;
  palpate::PathTouch touch(scene, parameters, firstTick_s);
  std::optional<double> arrived_s;
  for (const palpate::PathSample& row : path)
  {
    const palpate::HapticState now = touch.next(row.time_s, row.hand_W);
    trace.Row({ row.time_s, row.hand_W.p, now.proxy_W.p, now.force_D.norm() });
    if (!arrived_s && (now.proxy_W.p.head<2>() - *labyrinth.exit_W).norm() <= labyrinth.exitReach_u())
    {
      arrived_s = row.time_s;
    }
  }
  trace.Commit();
  std::cout << labyrinth.name << ": ";
  arrived_s ? std::cout << "arrived after " << *arrived_s - path.front().time_s << " s\n"
            : std::cout << "the path does not arrive at the exit\n";
  return arrived_s ? 0 : NotArrived;
}
} // namespace

int vtkHapticCliLabyrinth(const vtkHapticCliLabyrinthOptions& options)
{
  CheckOptions(options);
  if (options.Play)
  {
    return vtkHapticCliPlay(ToPlay(options), options);
  }
  if (options.File.empty())
  {
    return List();
  }
  const palpate::Labyrinth labyrinth = Read(options.File, options.Corridor_u);
  const std::string lacking = palpate::refuse(labyrinth);
  if (!options.Solve && options.Path.empty())
  {
    Describe(labyrinth);
    std::cout << lacking << (lacking.empty() ? "" : "\n");
    return 0;
  }
  if (!lacking.empty())
  {
    throw vtkHapticCliProblem(lacking);
  }
  return options.Path.empty() ? Solve(labyrinth, options) : Follow(labyrinth, options);
}
