// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "testing/haptics/recording/FixtureSessions.h"
#include "testing/haptics/recording/RecordedTicks.h"
#include "testing/haptics/session/HoldingTick.h"

namespace palpate::test
{
namespace
{

const Vec3 exit_W(0.008, 0.01, 0.0);

/// A game in a corridor 20 mm wide, whose exit is at its wall.
HapticParameters guided()
{
  HapticParameters parameters;
  parameters.stiffness_N_per_m = 400.0;
  parameters.contact.radius_u = 0.001;
  parameters.guide.on = true;
  parameters.guide.ramp_s = 0.02;
  parameters.game.on = true;
  parameters.game.exit_W = exit_W;
  parameters.game.exitReach_u = 0.003;
  parameters.game.near_m = 0.001;
  parameters.game.fade_s = 0.02;
  parameters.game.shake_s = 0.02;
  parameters.safety.engageRamp_s = 0.01;
  parameters.safety.deadMan.buttons = 1;
  return parameters;
}

HapticParameters held()
{
  HapticParameters parameters = guided();
  parameters.guide.on = false;
  parameters.walls = { true, 0.004, 1e-5, 2.0 };
  return parameters;
}

/// A hand that goes where the game wants it: to the start, the origin, and then behind the wall at the exit.
Vec3 ledHand(const Vec3& p_D, GamePhase phase, double height_m)
{
  const Vec3 behindExit_W(exit_W.x(), 0.0112, 0.0);
  const Vec3 to_D = phase == GamePhase::Explores || phase == GamePhase::Arrived ? behindExit_W : Vec3::Zero();
  const Vec3 way_D = to_D - Vec3(p_D.x(), p_D.y(), 0.0);
  const Vec3 at_D = Vec3(p_D.x(), p_D.y(), 0.0) + way_D * std::min(1.0, 0.0008 / std::max(1e-9, way_D.norm()));
  return { at_D.x(), at_D.y(), height_m };
}

} // namespace

std::string recordPlane(const std::string& path)
{
  constexpr int ticksInAll = 150, deviceHoldsFrom = 66;
  RecordedTicks ticks(path, guided());
  ticks.setScene(sceneOf(corridor(0.01)));
  Vec3 p_D(-0.004, 0.002, 0.002);
  GamePhase phase = GamePhase::Off;
  for (int tick = 1; tick <= ticksInAll; ++tick)
  {
    if (tick == 2)
    {
      ticks.push(EventKind::Engage);
    }
    if (tick == deviceHoldsFrom)
    {
      ticks.setParameters(held());
      ticks.push(EventKind::Play);
    }
    ticks.sample.buttons = tick >= 142 && tick < 145 ? 0 : 1;
    p_D = ledHand(p_D, phase, tick < deviceHoldsFrom ? 0.002 : 0.0);
    phase = ticks.tickAt(p_D).game;
  }
  return ticks.close();
}

} // namespace palpate::test
