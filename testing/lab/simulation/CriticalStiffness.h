// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "testing/lab/simulation/FreeDevice.h"
#include "testing/lab/simulation/WallRig.h"

namespace palpate::lab
{

/// `pressed` is pushed onto the wall with its push_N (> 0), by nobody's hand; its start is set here.
///
/// Does the motion about the equilibrium grow? The device starts a little off it and must not lose contact; judged
/// by the energy K dz^2 + m v^2 of a late stretch of cycles against that of an early one.
[[nodiscard]] bool grows(const FreeDevice& pressed, const WallSetup& setup);

/// The stiffness at which motion begins to grow [N/m], found by bisection between a stable and an unstable one;
/// `setup` gives the loop for a stiffness. 0 if even the least grows, `most` if none does.
[[nodiscard]] double measuredCriticalStiffness(const FreeDevice& pressed,
  const std::function<WallSetup(double stiffness_N_per_m)>& setup, double most_N_per_m = 1e5);

} // namespace palpate::lab
