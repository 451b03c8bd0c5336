// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/wire/WireHand.h"

#include <algorithm>

#include "haptics/core/PoseMath.h"
#include "haptics/tool/motion/Turn.h"

namespace palpate
{
namespace
{

/// A wire that is pulled out stays in the sheath, and the hand slides along it.
void pull(const WireInput& input, double most_u, WireState& state) noexcept
{
  const double out_u = -input.plan->wire.beams[0].length_u;
  state.led_u = std::clamp(handAlong_u(input) - state.grip_u, state.led_u - most_u, state.led_u + most_u);
  if (state.led_u < out_u)
  {
    state.grip_u = handAlong_u(input) - out_u;
    state.led_u = out_u;
  }
}

/// Where the sheath holds its turn the outer end is turned at once, else the hand's spring turns it.
void turn(const WireInput& input, WireState& state) noexcept
{
  const Quat& m = input.plan->mouth_W.q;
  const Quat turn_M = m.conjugate() * (input.hand_W.q * state.hand_W.conjugate()) * m;
  state.handTurn_rad += rotationVector(turn_M).x() + input.turnBy_rad;
  state.hand_W = input.hand_W.q;
  if (!(input.turning_Nu_per_rad > 0.0) && input.turnBy_rad != 0.0)
  {
    Quat& q = state.places_M[0].q;
    q = (Quat(Eigen::AngleAxisd(input.turnBy_rad, Vec3::UnitX())) * q).normalized();
    state.turned_rad += input.turnBy_rad;
  }
}

} // namespace

double handAlong_u(const WireInput& input) noexcept
{
  return into(input.plan->mouth_W, input.hand_W.p).x();
}

double takeWireHand(const WireInput& input, double most_u, WireState& state) noexcept
{
  const double before_u = state.led_u;
  pull(input, most_u, state);
  turn(input, state);
  return state.led_u - before_u;
}

} // namespace palpate
