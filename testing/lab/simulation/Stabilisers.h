// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>
#include <functional>
#include <string>
#include <vector>

#include "testing/lab/simulation/WallRig.h"

namespace palpate::lab
{

/// A method to keep a sampled wall from shaking, with its linear theory.
struct Stabiliser
{
  std::string name;
  /// The loop for a stiffness and a period. Each call gives a fresh one: some have a memory.
  std::function<WallSetup(double stiffness_N_per_m, double period_s)> setup;
  /// Rendered over wanted force of a spring under a motion of `omega` [rad/s], the hold of a period included.
  std::function<std::complex<double>(double omega, double stiffness_N_per_m, double period_s)> response;
  /// Drag on a hand in free air [N s/m].
  double viscosity_Ns_per_m = 0.0;
};

/// Nothing, a damper in contact, viscosity everywhere, a filtered force, and the product's controller.
[[nodiscard]] std::vector<Stabiliser> stabilisers();

} // namespace palpate::lab
