// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/simulated/labyrinth/LabyrinthPlayer.h"
#include "haptics/session/HapticSession.h"

namespace palpate
{
namespace
{

constexpr double tick_s = 1e-3;
constexpr double pause_s = 0.2; // between two turns, with nothing pressed
constexpr double press_s = 0.1; // for a button that chooses and need not be held

} // namespace

LabyrinthPlayer::LabyrinthPlayer(
  SimulatedDevice& device, const LabyrinthRun& run, const std::vector<LabyrinthOnOffer>& mazes, const DeadMan& deadMan)
  : device_(device), run_(run), mazes_(mazes), menu_(static_cast<int>(mazes.size()), deadMan)
{
}

void LabyrinthPlayer::press(const HapticState& state)
{
  const std::uint32_t chooses = 1u << this->turn_;
  const bool last = this->turn_ == this->mazes_.size();
  const DeadMan held = last ? DeadMan{} : this->menu_.heldFor(static_cast<int>(this->turn_) + 1);
  const bool pauses = this->since_s_ < pause_s;
  const std::uint32_t chosen = this->since_s_ < pause_s + press_s ? chooses : 0u;
  this->device_.press(pauses || this->over_ ? 0u : chosen | held.buttons);
  this->begun_ = this->begun_ || isPlayed(state.game);
  this->over_ = this->over_ || (this->begun_ && !isPlayed(state.game) && state.game != GamePhase::Arrived) ||
                this->since_s_ > this->run_.mostTime_s;
}

/// The next turn begins when the game of this turn is over and no game is played.
void LabyrinthPlayer::goOn()
{
  this->turn_ += this->turn_ < this->mazes_.size() ? 1 : 0;
  this->begun_ = this->over_ = false;
  this->since_s_ = 0.0;
  this->hand_.reset();
}

Vec3 LabyrinthPlayer::explore(const HapticState& state, const Vec3& handle_D, const WorkspaceMap& map)
{
  if (!this->hand_)
  {
    const Labyrinth& labyrinth = this->mazes_[this->turn_].labyrinth;
    const Vec3 start_W(labyrinth.start_W->x(), labyrinth.start_W->y(), 0.0);
    this->hand_.emplace(blindPlan(labyrinth, this->run_, map), map.toDevice(start_W));
  }
  const Vec3 arm_D = this->hand_->look(feltOf(state, handle_D, map), tick_s);
  this->over_ = this->over_ || this->hand_->exhausted() || this->hand_->lost();
  return arm_D;
}

void LabyrinthPlayer::look(const HapticState& state, const WorkspaceMap& map)
{
  const Vec3 handle_D = map.toDevice(state.device_W.p);
  this->since_s_ += tick_s;
  this->press(state);
  // A hand that does not explore follows the handle.
  this->device_.lead(state.game == GamePhase::Explores ? this->explore(state, handle_D, map) : handle_D);
  if (this->over_ && (state.game == GamePhase::Off || state.game == GamePhase::Waits))
  {
    this->goOn();
  }
}

} // namespace palpate
