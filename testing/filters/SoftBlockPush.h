// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "testing/oracles/axisymmetric/BallOnLayer.h"

namespace palpate::testing
{

/// The force of a ball on the block of makeSoftBlock() of 100 mm: the layer below the ball and the hand's spring are in
/// series, so that the spring is as much shorter than the hand's depth as the ball is deep in the layer.
inline double pushOfSoftBlock_N(double ball_m, double hand_m, double spring_N_per_m)
{
  const oracle::Layer layer{ 20e3, 0.4, 0.05 };
  double least_m = 0.0, most_m = hand_m;
  for (int halving = 0; halving < 40; ++halving)
  {
    const double deep_m = 0.5 * (least_m + most_m);
    const bool springIsStronger =
      spring_N_per_m * (hand_m - deep_m) > oracle::contactOfDepth(layer, ball_m, deep_m).force_N;
    (springIsStronger ? least_m : most_m) = deep_m;
  }
  return spring_N_per_m * (hand_m - most_m);
}

/// Share of the force by which bodies differ from the layer's solution at most (see MeshStudy).
inline constexpr double offLayer = 0.03;

} // namespace palpate::testing
