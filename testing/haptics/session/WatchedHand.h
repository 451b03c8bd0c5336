// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <functional>
#include <limits>

#include "devices/simulated/SimulatedDevice.h"
#include "haptics/session/HapticSession.h"
#include "haptics/tool/motion/Turn.h"

namespace palpate::test
{

/// All that a simulated hand with six axes was seen to do.
struct WatchedHand
{
  double pressed_N = 0.0, turned_Nm = 0.0;
  double step_N = 0.0;                         ///< largest change of the force in a tick
  double trembles_m = 0.0, trembles_rad = 0.0; ///< in the last ticks
  double excess_J = 0.0;
  Fault fault = Fault::None;
};

/// Leads the hand of a device that runs for so many ticks of a millisecond, and watches how still it is in the last.
inline WatchedHand watchHand(HapticSession& session, SimulatedDevice& device,
  const std::function<Pose(double time_s)>& hand_W, int ticks, int last)
{
  constexpr double tick_s = 1e-3;
  constexpr int starts = 5; // the first ticks have no hand yet
  WatchedHand seen;
  Vec3 low_m = Vec3::Constant(std::numeric_limits<double>::infinity()), high_m = -low_m, low_rad = low_m,
       high_rad = high_m, before_N = Vec3::Zero();
  for (int i = 0; i < ticks; ++i)
  {
    device.lead(hand_W(i * tick_s));
    session.step(1);
    const HapticState& state = session.state();
    seen.pressed_N = std::max(seen.pressed_N, state.force_D.norm());
    seen.turned_Nm = std::max(seen.turned_Nm, state.torque_D.norm());
    seen.excess_J = std::max(seen.excess_J, state.energy.peakExcess_J);
    seen.step_N = std::max(seen.step_N, (state.force_D - before_N).norm());
    before_N = state.force_D;
    seen.fault = i > starts && state.fault != Fault::None ? state.fault : seen.fault;
    if (i >= ticks - last)
    {
      const Vec3 turn = rotationVector(device.turning()->turn_D());
      low_m = low_m.cwiseMin(device.position_D());
      high_m = high_m.cwiseMax(device.position_D());
      low_rad = low_rad.cwiseMin(turn);
      high_rad = high_rad.cwiseMax(turn);
    }
  }
  seen.trembles_m = (high_m - low_m).maxCoeff();
  seen.trembles_rad = (high_rad - low_rad).maxCoeff();
  return seen;
}

} // namespace palpate::test
