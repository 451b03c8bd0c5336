// SPDX-License-Identifier: GPL-3.0-or-later
// The game of finding the way: what is played, and where it stands.
#include "haptics/labyrinth/Labyrinth.h"
#include "vtkDataObject.h"
#include "vtkHapticLabyrinthData.h"
#include "vtkHapticSessionInternals.h"

bool vtkHapticSession::PlayLabyrinth(vtkDataObject* maze, const char* name)
{
  vtkHapticLabyrinthResult read;
  if (maze)
  {
    read = vtkHapticToLabyrinth(maze, name ? name : "labyrinth");
  }
  const std::string problem = !maze                  ? "there is no labyrinth to play"
                              : read.Problem.empty() ? palpate::refuse(read.Labyrinth)
                                                     : read.Problem;
  if (!problem.empty())
  {
    this->Refuse(problem);
    return false;
  }
  const palpate::Labyrinth& labyrinth = read.Labyrinth;
  this->SetLinesAsWalls(On);
  const double workspace_m = this->Impl->ChosenInfo().workspaceRadius_m.value;
  this->Change(
    [&](palpate::HapticParameters& p)
    {
      p.game = palpate::gameOf(labyrinth);
      p.contact.radius_u = labyrinth.radius_u();
      p.map =
        palpate::fitted(labyrinth, workspace_m > 0.0 ? workspace_m : palpate::DeviceInfo().workspaceRadius_m.value);
    });
  if (this->Impl->Stroke_W.empty()) // where a simulated hand begins that nobody told
  {
    this->Impl->Stroke_W.push_back(this->Impl->Parameters.map.offset_W);
  }
  return this->GetLabyrinthPlayed();
}

void vtkHapticSession::PlayAgain()
{
  this->Impl->Core.play();
}

void vtkHapticSession::EndLabyrinth()
{
  this->Change([](palpate::HapticParameters& p) { p.game.on = false; });
}

bool vtkHapticSession::GetLabyrinthPlayed() const
{
  return this->Impl->Parameters.game.on;
}

const char* vtkHapticSession::GetLabyrinthPhase() const
{
  return palpate::name(this->Impl->State.game);
}

double vtkHapticSession::GetLabyrinthTime() const
{
  return this->Impl->State.gameTime_s;
}
