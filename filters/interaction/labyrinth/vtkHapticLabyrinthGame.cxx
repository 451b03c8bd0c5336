// SPDX-License-Identifier: GPL-3.0-or-later
// The labyrinth game: which one is played, its phase, and the path so far.
#include "vtkHapticLabyrinthGame.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "haptics/force/FeatureSize.h"
#include "haptics/labyrinth/Labyrinth.h"
#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkHapticGameState.h"
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

vtkSmartPointer<vtkHapticLabyrinthGame> vtkHapticLabyrinthGame::Of(vtkHapticSession& session)
{
  return vtkSmartPointer<vtkHapticLabyrinthGame>::Take(new vtkHapticLabyrinthGame(session));
}

bool vtkHapticLabyrinthGame::Play(vtkDataObject* maze, const char* name)
{
  const std::string label = name ? name : "labyrinth";
  vtkHapticLabyrinthResult read;
  read.Problem = label + ": no labyrinth in these data; see the message of the source if it failed";
  if (maze && maze->GetNumberOfElements(vtkDataObject::CELL) > 0)
  {
    read = vtkHapticToLabyrinth(maze, label);
  }
  if (!read.Problem.empty())
  {
    this->Behind().Refuse(read.Problem);
    return false;
  }
  const palpate::Labyrinth& labyrinth = read.Labyrinth;
  this->Behind().Game.Corridor_u = labyrinth.corridor_u;
  this->Behind().Game.Log.begin(traceApart * labyrinth.corridor_u);
  this->Behind().Problem = palpate::refuse(labyrinth); // that a structure is none is no fault: it is explored
  this->Behind().ProblemOf.clear();
  const bool played = this->Behind().Problem.empty();
  this->Session->SetSetting("LinesAsWalls", vtkHapticSession::On);
  const double workspace_m = this->Behind().InfoNow().workspaceRadius_m.value;
  this->Behind().Change(
    [&](palpate::HapticParameters& p)
    {
      p.game = played ? palpate::gameOf(labyrinth) : palpate::GamePlan();
      p.contact.radius_u = labyrinth.radius_u();
      p.map =
        palpate::fitted(labyrinth, workspace_m > 0.0 ? workspace_m : palpate::DeviceInfo().workspaceRadius_m.value);
    });
  this->Behind().FollowWalls();
  this->Behind().Core.play(); // a game that went on begins again: the plan alone does not say that it is another
  if (this->Behind().Stroke_W.empty()) // where a simulated hand begins without a path
  {
    this->Behind().Stroke_W.push_back(this->Behind().Asked.asked().map.offset_W);
  }
  this->Session->InvokeEvent(vtkCommand::PropertyModifiedEvent);
  return this->GetPlayed();
}

void vtkHapticLabyrinthGame::PlayAgain()
{
  this->Behind().Core.play();
}

void vtkHapticLabyrinthGame::End()
{
  this->Behind().Change([](palpate::HapticParameters& p) { p.game.on = false; });
}

bool vtkHapticLabyrinthGame::GetPlayed() const
{
  return this->Behind().Asked.asked().game.on;
}

void vtkHapticLabyrinthGame::GetPlaces(double start_W[3], double exit_W[3]) const
{
  const palpate::GamePlan& game = this->Behind().Asked.asked().game;
  Eigen::Map<palpate::Vec3>{ start_W } = game.start_W;
  Eigen::Map<palpate::Vec3>{ exit_W } = game.exit_W;
}

double vtkHapticLabyrinthGame::GetReach() const
{
  return this->Behind().Asked.asked().game.exitReach_u;
}

const char* vtkHapticLabyrinthGame::GetPhase() const
{
  return palpate::name(this->Behind().State.game);
}

double vtkHapticLabyrinthGame::GetTime() const
{
  return this->Behind().State.gameTime_s;
}

const char* vtkHapticLabyrinthGame::GetText() const
{
  const bool alone = this->Behind().State.game == palpate::GamePhase::Leads && !this->Session->GetDeviceGivesForce();
  return alone ? "move to the start yourself (the device renders no force)" : this->GetPhase();
}

double vtkHapticLabyrinthGame::GetFeelableWidth() const
{
  const double stiffness_N_per_m = this->Behind().FeltStiffness();
  return stiffness_N_per_m > 0.0 ? palpate::smallestFeature_m(pressing_N, stiffness_N_per_m)
                                 : std::numeric_limits<double>::infinity();
}

double vtkHapticLabyrinthGame::GetFeelableZoom() const
{
  const double width_m = this->Behind().Game.Corridor_u / this->Session->GetSetting("Scale"),
               stiffness_N_per_m = this->Behind().FeltStiffness();
  if (!(width_m > 0.0))
  {
    return 1.0;
  }
  return stiffness_N_per_m > 0.0 ? palpate::zoomToFeel(width_m, pressing_N, stiffness_N_per_m)
                                 : std::numeric_limits<double>::infinity();
}

void vtkHapticLabyrinthGame::GetTrace(vtkPolyData* trace) const
{
  if (!trace)
  {
    return;
  }
  const std::vector<palpate::Vec3>& way_W = this->Behind().Game.Log.trace().points_W();
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

int vtkHapticLabyrinthGame::TakeWish()
{
  return this->Behind().Game.Log.takeWish();
}

// Of the session -----------------------------------------------------------------------------------------------------

bool vtkHapticSession::GetDeviceGivesForce() const
{
  return this->Impl->InfoNow().rendersForce;
}

double vtkHapticSession::Internals::FeltStiffness() const
{
  return palpate::feltStiffness_N_per_m(this->Asked.asked(), this->InfoNow(), this->Limits);
}

void vtkHapticSession::Internals::FollowGame()
{
  const palpate::HapticState& state = this->State;
  this->Game.Log.look({ state.tick, state.game, state.gameTime_s, state.buttons, state.proxy_W.p },
    this->Asked.asked().safety.deadMan.buttons);
}
