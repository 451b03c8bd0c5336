// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/LabyrinthHost.h"

#include "haptics/session/HapticSession.h"
#include <utility>

namespace palpate
{

LabyrinthHost::LabyrinthHost(HapticSession& session, const std::vector<LabyrinthOnOffer>& mazes, const DeadMan& deadMan)
  : session_(session), mazes_(mazes), menu_(static_cast<int>(mazes.size()), deadMan)
{
  session.setScene(mazes.front().walls); // a session without a scene has a fault
}

const Labyrinth* LabyrinthHost::chosen() const noexcept
{
  return this->chosen_ > 0 ? &this->mazes_[static_cast<std::size_t>(this->chosen_ - 1)].labyrinth : nullptr;
}

LabyrinthNews LabyrinthHost::look()
{
  const HapticState& state = this->session_.state();
  const LabyrinthCall call =
    this->menu_.look(state.game, state.buttons, state.time_s - std::exchange(this->seen_s_, state.time_s));
  if (this->on_ && state.fault != Fault::None)
  {
    this->end();
    return LabyrinthNews::Fault;
  }
  const LabyrinthNews news = this->obey(call, state);
  return news != LabyrinthNews::None ? news : this->follow(state);
}

LabyrinthNews LabyrinthHost::obey(const LabyrinthCall& call, const HapticState& state)
{
  const bool letGo = this->on_ && this->menu_.chooserHolds() && state.letGo && isPlayed(this->phase_);
  if (call.kind == LabyrinthCall::Kind::GiveUp || letGo)
  {
    this->end();
    return LabyrinthNews::GaveUp;
  }
  if (call.kind == LabyrinthCall::Kind::End)
  {
    this->end();
    return LabyrinthNews::End;
  }
  if (call.kind == LabyrinthCall::Kind::Play)
  {
    this->end();
    this->chosen_ = call.maze;
    this->waiting_ = true;
    return LabyrinthNews::Chosen;
  }
  return LabyrinthNews::None;
}

LabyrinthNews LabyrinthHost::follow(const HapticState& state)
{
  if (this->waiting_ && state.gain == 0.0 && state.game == GamePhase::Off)
  {
    this->begin();
    return LabyrinthNews::None;
  }
  const GamePhase before = std::exchange(this->phase_, this->on_ ? state.game : GamePhase::Off);
  this->gameTime_s_ = this->on_ ? state.gameTime_s : this->gameTime_s_;
  if (this->phase_ == before)
  {
    return LabyrinthNews::None;
  }
  switch (this->phase_)
  {
    case GamePhase::Leads:
      return LabyrinthNews::Leads;
    case GamePhase::LetsGo:
      return LabyrinthNews::LetGo;
    case GamePhase::Arrived:
      return LabyrinthNews::Arrived;
    case GamePhase::Rests:
      this->end();
      return LabyrinthNews::None;
    default:
      return LabyrinthNews::None;
  }
}

void LabyrinthHost::begin()
{
  const LabyrinthOnOffer& maze = this->mazes_[static_cast<std::size_t>(this->chosen_ - 1)];
  HapticParameters parameters = this->session_.parameters();
  parameters.game = gameOf(maze.labyrinth);
  parameters.contact.radius_u = maze.labyrinth.radius_u();
  const double workspace_m = this->session_.device()->info().workspaceRadius_m.value;
  parameters.map = fitted(maze.labyrinth, workspace_m > 0.0 ? workspace_m : DeviceInfo().workspaceRadius_m.value);
  parameters.safety.deadMan = this->held();
  this->session_.setScene(maze.walls);
  // Its numbers are those of a labyrinth that was checked before it was offered.
  static_cast<void>(this->session_.setParameters(parameters));
  this->session_.engage();
  this->waiting_ = false;
  this->on_ = true;
}

void LabyrinthHost::end()
{
  HapticParameters parameters = this->session_.parameters();
  parameters.game.on = false;
  static_cast<void>(this->session_.setParameters(parameters));
  this->session_.release();
  this->waiting_ = this->on_ = false;
  this->phase_ = GamePhase::Off;
}

} // namespace palpate
