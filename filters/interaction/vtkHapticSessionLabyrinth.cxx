// SPDX-License-Identifier: GPL-3.0-or-later
// The game of finding the way: what is played, where it stands, and the way so far.
#include <algorithm>
#include <limits>
#include <utility>

#include "haptics/force/FeatureSize.h"
#include "haptics/labyrinth/Labyrinth.h"
#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkHapticLabyrinthData.h"
#include "vtkHapticSessionInternals.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace
{
constexpr double pressing_N = 1.0; // of a hand that explores
constexpr double traceApart = 0.1; // of a corridor
} // namespace

bool vtkHapticSession::PlayLabyrinth(vtkDataObject* maze, const char* name)
{
  const std::string label = name ? name : "labyrinth";
  vtkHapticLabyrinthResult read;
  read.Problem = label + ": there is nothing to play; if it comes from a source that failed, that one says why";
  if (maze && maze->GetNumberOfElements(vtkDataObject::CELL) > 0)
  {
    read = vtkHapticToLabyrinth(maze, label);
  }
  if (!read.Problem.empty())
  {
    this->Refuse(read.Problem);
    return false;
  }
  const palpate::Labyrinth& labyrinth = read.Labyrinth;
  this->Impl->Corridor_u = labyrinth.corridor_u;
  this->Impl->Game.begin(traceApart * labyrinth.corridor_u);
  this->Impl->Problem = palpate::refuse(labyrinth); // that a structure is none is no fault: it is explored
  this->Impl->ProblemOf.clear();
  const bool played = this->Impl->Problem.empty();
  this->SetLinesAsWalls(On);
  const double workspace_m = this->Impl->InfoNow().workspaceRadius_m.value;
  this->Change(
    [&](palpate::HapticParameters& p)
    {
      p.game = played ? palpate::gameOf(labyrinth) : palpate::GamePlan();
      p.contact.radius_u = labyrinth.radius_u();
      p.map =
        palpate::fitted(labyrinth, workspace_m > 0.0 ? workspace_m : palpate::DeviceInfo().workspaceRadius_m.value);
    });
  this->Impl->FollowWalls();
  this->Impl->Core.play();          // a game that went on begins again: the plan alone does not say that it is another
  if (this->Impl->Stroke_W.empty()) // where a simulated hand begins that nobody told
  {
    this->Impl->Stroke_W.push_back(this->Impl->Asked.asked().map.offset_W);
  }
  this->InvokeEvent(vtkCommand::PropertyModifiedEvent);
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
  return this->Impl->Asked.asked().game.on;
}

void vtkHapticSession::GetLabyrinthPlaces(double start_W[3], double exit_W[3]) const
{
  const palpate::GamePlan& game = this->Impl->Asked.asked().game;
  Eigen::Map<palpate::Vec3>{ start_W } = game.start_W;
  Eigen::Map<palpate::Vec3>{ exit_W } = game.exit_W;
}

double vtkHapticSession::GetLabyrinthReach() const
{
  return this->Impl->Asked.asked().game.exitReach_u;
}

const char* vtkHapticSession::GetLabyrinthPhase() const
{
  return palpate::name(this->Impl->State.game);
}

double vtkHapticSession::GetLabyrinthTime() const
{
  return this->Impl->State.gameTime_s;
}

const char* vtkHapticSession::GetLabyrinthText() const
{
  const bool alone = this->Impl->State.game == palpate::GamePhase::Leads && !this->GetDeviceGivesForce();
  return alone ? "go to the start yourself (no force)" : this->GetLabyrinthPhase();
}

bool vtkHapticSession::GetDeviceGivesForce() const
{
  return this->Impl->InfoNow().rendersForce;
}

double vtkHapticSession::GetFeelableWidth() const
{
  const double stiffness_N_per_m = this->Impl->FeltStiffness();
  return stiffness_N_per_m > 0.0 ? palpate::smallestFeature_m(pressing_N, stiffness_N_per_m)
                                 : std::numeric_limits<double>::infinity();
}

double vtkHapticSession::GetFeelableZoom() const
{
  const double width_m = this->Impl->Corridor_u / this->GetScale(), stiffness_N_per_m = this->Impl->FeltStiffness();
  if (!(width_m > 0.0))
  {
    return 1.0;
  }
  return stiffness_N_per_m > 0.0 ? palpate::zoomToFeel(width_m, pressing_N, stiffness_N_per_m)
                                 : std::numeric_limits<double>::infinity();
}

double vtkHapticSession::Internals::FeltStiffness() const
{
  return palpate::feltStiffness_N_per_m(this->Asked.asked(), this->InfoNow(), this->Limits);
}

void vtkHapticSession::GetLabyrinthTrace(vtkPolyData* trace) const
{
  if (!trace)
  {
    return;
  }
  const std::vector<palpate::Vec3>& way_W = this->Impl->Game.trace().points_W();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(static_cast<int>(way_W.size()));
  for (const palpate::Vec3& p_W : way_W)
  {
    lines->InsertCellPoint(points->InsertNextPoint(p_W.data()));
  }
  trace->Initialize();
  trace->SetPoints(points);
  if (way_W.size() > 1)
  {
    trace->SetLines(lines);
  }
}

int vtkHapticSession::TakeLabyrinthWish()
{
  return this->Impl->Game.takeWish();
}

void vtkHapticSession::Internals::FollowGame()
{
  const palpate::HapticState& state = this->State;
  this->Game.look({ state.tick, state.game, state.gameTime_s, state.buttons, state.proxy_W.p },
    this->Asked.asked().safety.deadMan.buttons);
}
