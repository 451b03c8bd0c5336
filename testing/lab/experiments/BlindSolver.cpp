// SPDX-License-Identifier: GPL-3.0-or-later
// The labyrinth as a regression test: Tremaux's rules with a memory for places, a simulated hand on a simulated device.
// A maze has a path (testing/scripts/test_gallery.py searches it among the walls), so a hand that feels right arrives:
// every device, in every hand that holds it.
#include <array>
#include <string>

#include "devices/simulated/labyrinth/LabyrinthRun.h"
#include "testing/lab/Experiments.h"
#include "testing/lab/backends/Gallery.h"

namespace palpate::lab
{
namespace blind_solver_experiment
{

void judge(const Labyrinth& maze, const std::string& name, const LabyrinthRun& run, Table& table)
{
  const std::string caseName = "maze=" + name + " device=" + run.device.name + " hand=" + run.hand.name;
  const std::string method = run.deviceHoldsWalls ? "four walls, 20 Hz host" : "host-closed, 1 kHz";
  const LabyrinthOutcome outcome = runBlind(maze, run);
  table.within({ caseName, method, "arrives" }, outcome.problem.empty() ? 1 : 0, 1, 0);
  table.info({ caseName, method, "virtual time", "s" }, outcome.time_s);
  table.info({ caseName, method, "way of the disc", "corridor widths" }, outcome.way_u / maze.corridor_u);
  table.info({ caseName, method, "places known", "places" }, static_cast<double>(outcome.places));
}

void judgeHand(const Labyrinth& maze, const std::string& name, const HandModel& hand, Table& table)
{
  for (const DeviceModel& device : deviceModels())
  {
    if (device.turns())
    {
      continue; // in a maze it goes as the one without a turn does
    }
    judge(maze, name, { .device = device, .hand = hand }, table);
    if (device.loop_s > 0.0)
    {
      judge(maze, name, { .device = device, .hand = hand, .host_Hz = 20.0, .deviceHoldsWalls = true }, table);
    }
  }
}

} // namespace blind_solver_experiment

void runBlindSolver(const Conditions& conditions, Table& table)
{
  using namespace blind_solver_experiment;
  const std::vector<std::string> quick{ "corridor", "spiral", "hampton-court" };
  const std::vector<std::string> all{ "corridor", "spiral", "hampton-court", "chartres", "versailles" };
  const std::vector<std::string> onlyFirm{ "firm" }, holding{ "light", "stylus", "firm" };
  const std::vector<std::string>& hands = conditions.pick(onlyFirm, holding, holding);
  const std::vector<std::string>& names = conditions.pick(quick, all, all);
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    const std::optional<Labyrinth> maze = galleryMaze(names[i]);
    if (!maze)
    {
      table.absent({ "maze=" + names[i], "blind hand", "arrives" });
      continue;
    }
    for (const std::string& hand : hands)
    {
      judgeHand(*maze, names[i], *handModel(hand), table);
    }
    conditions.progress(static_cast<double>(i + 1) / static_cast<double>(names.size()));
  }
}

} // namespace palpate::lab
