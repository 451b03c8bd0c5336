// SPDX-License-Identifier: GPL-3.0-or-later
// The game as the tick plays it, with simulated devices in simulated hands.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "devices/simulated/SimulatedDevice.h"
#include "haptics/labyrinth/Labyrinth.h"
#include "haptics/safety/ForceLimits.h"
#include "haptics/session/DeviceAdaptation.h"
#include "haptics/tick/ForceRenderer.h"

namespace palpate
{
namespace
{

constexpr double tick_s = 1e-3;

/// A closed box of 20 by 20 with the start in its middle and the exit to its right.
Labyrinth box()
{
  Labyrinth labyrinth;
  labyrinth.name = "box";
  labyrinth.curves = { { { -10, -10 }, { 10, -10 }, { 10, 10 }, { -10, 10 } },
    { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 } } };
  labyrinth.start_W = Eigen::Vector2d(0, 0);
  labyrinth.exit_W = Eigen::Vector2d(8, 0);
  return labyrinth;
}

/// A game in the tick, on a device whose hand holds still where the device is, or leads it.
class Game
{
public:
  Game(const DeviceModel& model, const HandModel& hand, const Vec3& from_D, bool deviceHolds = false,
    const Labyrinth& labyrinth = box())
    : scene_(SceneBuilder().build({ wallsOf(labyrinth) }).scene),
      device_(model, hand, { { from_D } }, { .period_s = tick_s }), hand_D_(from_D)
  {
    EXPECT_EQ(this->device_.open(), "");
    const DeviceInfo info = infoOf(model);
    HapticParameters& p = this->parameters;
    p.contact.radius_u = labyrinth.radius_u();
    p.map = fitted(labyrinth, info.workspaceRadius_m.value);
    p.game = gameOf(labyrinth);
    p.walls.hold = deviceHolds;
    p.safety = SafetyLimits::forDevice(info);
    p.safety.needsEngage = false;
    p.safety.deadMan.grip = true;
    p = adaptToDevice(p, info, stabilityLimits(info, loopSettings(p, tick_s)));
  }

  TickOutput tick()
  {
    TickInput input;
    input.tick = ++this->tick_;
    input.status = this->lost ? DeviceStatus::Lost : DeviceStatus::Ok;
    input.scene = this->scene_.get();
    (void)this->device_.read(static_cast<double>(this->tick_) * tick_s, input.sample);
    input.sample.grip = this->grip;
    const TickOutput out = renderTick(input, this->parameters, this->state);
    this->device_.write(out.command);
    this->fastest_m_per_s = std::max(this->fastest_m_per_s, this->device_.speed_D().norm());
    this->strongest_N = std::max(this->strongest_N, out.state.force_D.norm());
    const bool shakes = out.command.signal == Signal::Oscillation;
    this->shakeOrders += shakes && !this->shakes_ ? 1 : 0;
    this->shakes_ = shakes;
    return out;
  }

  /// The hand wants to be where it has been drawn.
  TickOutput yieldingTick()
  {
    const TickOutput out = this->tick();
    this->device_.lead(this->device_.position_D());
    return out;
  }

  /// Until a phase is reached, 20 s at most. The hand goes where it is drawn unless it holds still.
  TickOutput until(GamePhase phase, bool yields = true)
  {
    TickOutput out;
    for (int k = 0; k < 20000 && out.state.game != phase; ++k)
    {
      out = yields ? this->yieldingTick() : this->tick();
    }
    return out;
  }

  void lead(const Vec3& p_W)
  {
    const Vec3 goal_D = this->parameters.map.toDevice(p_W);
    this->hand_D_ = this->device_.position_D();
    for (int k = 1; k <= 2000; ++k)
    {
      this->device_.lead(this->hand_D_ + k / 2000.0 * (goal_D - this->hand_D_));
      this->last = this->tick();
      this->shaken =
        this->shaken || (this->last.state.game == GamePhase::Arrived && this->last.state.force_D.norm() > 0.5);
      this->signals += this->last.command.signal == Signal::Oscillation ? 1 : 0;
    }
  }

  [[nodiscard]] double fromStart_m() const
  {
    return (this->device_.position_D() - this->parameters.map.toDevice(this->parameters.game.start_W)).norm();
  }

  HapticParameters parameters;
  RendererState state;
  TickOutput last;
  bool grip = true, lost = false, shaken = false;
  int signals = 0; ///< ticks that ask the device to shake
  double fastest_m_per_s = 0.0, strongest_N = 0.0;
  int shakeOrders = 0; ///< to a device that shakes by itself

private:
  std::shared_ptr<const Scene> scene_;
  SimulatedDevice device_;
  Vec3 hand_D_;
  std::uint64_t tick_ = 0;
  bool shakes_ = false;
};

/// The most that a lead gives a hand of that speed: its spring at its limit and its damper, side by side.
double mostOfALead_N(const GamePlan& plan, double speed_m_per_s)
{
  return plan.largest_N + plan.damping_Ns_per_m * speed_m_per_s;
}

TEST(LabyrinthGame, EveryDeviceInEveryHandIsBroughtToTheStartNoFasterThanAllowedAndLetGoNearIt)
{
  for (const DeviceModel& model : deviceModels())
  {
    for (const HandModel& hand : handModels())
    {
      Game game(model, hand, { -0.02, 0.015, 0 });
      const TickOutput out = game.until(GamePhase::LetsGo);
      ASSERT_EQ(out.state.game, GamePhase::LetsGo) << model.name << ", " << hand.name;
      EXPECT_LE(game.fromStart_m(), game.parameters.game.near_m + 2 * model.encoderStep_m) << model.name;
      game.until(GamePhase::Explores, false);
      EXPECT_GE(game.fastest_m_per_s, 0.02) << model.name << ", " << hand.name;
      EXPECT_LE(game.fastest_m_per_s, GamePlan::fastest_m_per_s) << model.name << ", " << hand.name;
      EXPECT_LE(game.strongest_N, mostOfALead_N(game.parameters.game, GamePlan::fastest_m_per_s))
        << model.name << ", " << hand.name;
    }
  }
}

// This device's position is exact, so a speed it estimates is a mean of true ones.
TEST(LabyrinthGame, AHandThatHoldsStillIsPulledWithNoMoreThanTheLimit)
{
  for (const HandModel& hand : handModels())
  {
    Game game(*deviceModel("simulated-generic"), hand, { -0.05, 0, 0 });
    for (int k = 0; k < 5000; ++k)
    {
      const TickOutput out = game.tick();
      if (out.state.game == GamePhase::Leads)
      {
        ASSERT_LE(out.state.force_D.norm(), mostOfALead_N(game.parameters.game, game.fastest_m_per_s)) << hand.name;
      }
    }
    const bool held = hand.stiffness_N_per_m > 0.0;
    EXPECT_EQ(game.state.game.phase == GamePhase::Leads, held) << hand.name;
    if (held)
    {
      EXPECT_NEAR(game.state.lastForce_D.norm(), game.parameters.game.largest_N, 0.01) << hand.name;
    }
  }
}

/// The box with a wall across the path from its left side to the start.
Labyrinth boxWithAWall()
{
  Labyrinth labyrinth = box();
  labyrinth.curves.points_W.insert(labyrinth.curves.points_W.end(), { { -2, -8 }, { -2, 8 } });
  labyrinth.curves.segments.push_back({ 4, 5 });
  return labyrinth;
}

TEST(LabyrinthGame, OnTheWayToTheStartNoWallIsFeltAndFromThereOnEachIs)
{
  Game game(*deviceModel("simulated-generic"), *handModel("firm"), { -0.04, 0, 0 }, false, boxWithAWall());
  const WorkspaceMap& map = game.parameters.map;
  const GamePlan& plan = game.parameters.game;
  ASSERT_LT(map.toScene({ -0.04, 0, 0 }).x(), -2.0); // the wall is between the hand and the start
  ASSERT_GE(game.parameters.stiffnessLimit_N_per_m, plan.stiffness_N_per_m);
  TickOutput out = game.until(GamePhase::Leads);
  for (int ticks = 0; ticks < 20000 && out.state.game == GamePhase::Leads; ++ticks)
  {
    const Vec3 stretch_D = game.state.game.drawn_D - map.toDevice(out.state.device_W.p);
    const Vec3 lead_N =
      clampMagnitude(plan.stiffness_N_per_m * stretch_D, plan.largest_N) - plan.damping_Ns_per_m * out.state.velocity_D;
    ASSERT_EQ(out.state.contacts, 0) << ticks;
    ASSERT_LE((out.state.rendered_D - lead_N).norm(), 1e-12) << ticks;
    out = game.yieldingTick();
  }
  EXPECT_EQ(out.state.game, GamePhase::LetsGo);
  game.until(GamePhase::Explores);
  game.lead({ 0, 12, 0 });
  EXPECT_GT(game.last.state.contacts, 0);
  EXPECT_NEAR(game.last.state.proxy_W.p.y(), 10 - box().radius_u(), 1e-9);
  EXPECT_LT(game.last.state.force_D.y(), 0.0);
}

TEST(LabyrinthGame, TheHandIsShakenAtTheExitOnlyAtItsFrequencyWithinItsAmplitudeAndForItsTime)
{
  Game game(*deviceModel("simulated-generic"), *handModel("firm"), { 0, 0, 0 });
  game.until(GamePhase::Explores);
  game.lead({ 5, 0, 0 });
  EXPECT_EQ(game.last.state.game, GamePhase::Explores);
  EXPECT_EQ(game.last.state.force_D.norm(), 0.0); // in the free, not at the exit
  EXPECT_FALSE(game.shaken);
  game.lead({ 8, 0, 0 });
  EXPECT_TRUE(game.shaken);
  // It arrived on the way; the same shaking, tick by tick, from the pure function.
  const GamePlan& plan = game.parameters.game;
  GameState state;
  state.phase = GamePhase::Explores;
  int turns = 0, ticks = 0;
  double before_N = 0.0;
  while (state.phase != GamePhase::Rests && ticks < 100000)
  {
    state.phase_s += tick_s;
    const double now_N = arrive(plan, plan.exit_W, tick_s, state).x();
    ASSERT_LE(std::fabs(now_N), plan.shake_N);
    turns += before_N * now_N < 0.0 ? 1 : 0;
    before_N = now_N != 0.0 ? now_N : before_N;
    ++ticks;
  }
  EXPECT_NEAR(ticks * tick_s, plan.shake_s, 2.5 * tick_s);
  EXPECT_NEAR(turns, 2 * plan.shake_Hz * plan.shake_s - 1, 1);
}

// The link to such a device is slower than the tick and takes the newest command only.
TEST(LabyrinthGame, ADeviceThatHoldsTheWallsIsAskedToShakeForAsLongAsTheHandIsShaken)
{
  Game game(*deviceModel("simulated-joystick"), *handModel("firm"), { 0, 0, 0 }, true);
  ASSERT_TRUE(game.parameters.walls.hold);
  game.until(GamePhase::Explores);
  game.lead({ 5, 0, 0 });
  EXPECT_EQ(game.signals, 0);
  game.lead({ 8, 0, 0 });
  game.lead({ 8, 0, 0 });
  EXPECT_EQ(game.last.state.game, GamePhase::Rests);
  EXPECT_NEAR(game.signals * tick_s, game.parameters.game.shake_s, 2.5 * tick_s);
}

TEST(LabyrinthGame, TheTimeIsThatOfExploringAndStopsAtTheExit)
{
  Game game(*deviceModel("simulated-generic"), *handModel("firm"), { 0, 0, 0 });
  game.until(GamePhase::Explores);
  game.lead({ 8, 0, 0 });
  const double time_s = game.last.state.gameTime_s;
  EXPECT_GT(time_s, 1.0);
  EXPECT_LT(time_s, 2.0); // two seconds to the exit's middle, less its reach
  for (int k = 0; k < 3000; ++k)
  {
    game.last = game.tick();
  }
  EXPECT_EQ(game.last.state.game, GamePhase::Rests);
  EXPECT_EQ(game.last.state.gameTime_s, time_s);
}

TEST(LabyrinthGame, WhoLetsGoAndGripsAgainIsBroughtToTheStartAgain)
{
  Game game(*deviceModel("simulated-generic"), *handModel("firm"), { 0, 0, 0 });
  game.until(GamePhase::Explores);
  game.lead({ 5, 0, 0 });
  game.grip = false;
  for (int k = 0; k < 200; ++k)
  {
    game.last = game.tick();
  }
  EXPECT_EQ(game.last.state.game, GamePhase::Waits);
  EXPECT_EQ(game.last.state.force_D.norm(), 0.0);
  game.grip = true;
  EXPECT_EQ(game.until(GamePhase::LetsGo).state.game, GamePhase::LetsGo);
  EXPECT_LE(game.fromStart_m(), game.parameters.game.near_m);
  EXPECT_EQ(game.state.game.time_s, 0.0);
}

TEST(LabyrinthGame, ALostDeviceEndsTheLeadWithoutAForceUntilThePersonAsksAgain)
{
  Game game(*deviceModel("simulated-generic"), *handModel("firm"), { -0.05, 0, 0 });
  game.until(GamePhase::Leads);
  game.lost = true;
  const TickOutput out = game.tick();
  EXPECT_EQ(out.state.fault, Fault::DeviceLost);
  game.lost = false;
  for (int k = 0; k < 1000; ++k)
  {
    const TickOutput later = game.tick();
    ASSERT_EQ(later.state.force_D.norm(), 0.0);
    ASSERT_EQ(later.state.game, GamePhase::Waits);
  }
}

TEST(LabyrinthGame, AJoystickThatHoldsWallsIsLedByThemAndToldToShakeOnce)
{
  Game game(*deviceModel("simulated-joystick"), *handModel("firm"), { -0.03, 0.02, 0 }, true);
  TickOutput out = game.until(GamePhase::Leads);
  for (int k = 0; k < 100; ++k)
  {
    out = game.tick();
  }
  EXPECT_EQ(out.command.wallCount, 4);
  EXPECT_EQ(out.command.wrench_D.force.norm(), 0.0);
  EXPECT_EQ(game.until(GamePhase::LetsGo).state.game, GamePhase::LetsGo);
  EXPECT_LE(game.fastest_m_per_s, GamePlan::fastest_m_per_s);
  game.until(GamePhase::Explores);
  game.lead({ 5, 0, 0 });
  EXPECT_EQ(game.shakeOrders, 0); // not at the exit
  game.lead({ 8, 0, 0 });
  game.lead({ 8, 0, 0 });
  EXPECT_EQ(game.last.state.game, GamePhase::Rests);
  EXPECT_EQ(game.shakeOrders, 1);
}

} // namespace
} // namespace palpate
