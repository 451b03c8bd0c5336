// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace palpate
{

/// A device against a virtual wall that is always in contact: m x'' + b x' = u, u held over each period and
/// u[k] = -( K x[k-d] + (B + lead K T) (x[k-d] - x[k-d-1]) / T ).
struct SampledWall
{
  double mass_kg = 0.1;
  double damping_Ns_per_m = 0.0;      ///< b of device and hand
  double handStiffness_N_per_m = 0.0; ///< spring to ground beside it
  double period_s = 1e-3;
  int delay_ticks = 0;
  double virtualDamping_Ns_per_m = 0.0; ///< B
  double leadPeriods = 0.0;             ///< damping that grows with K, as the passivity controller's does
};

/// Largest modulus of the closed loop's eigenvalues: below 1 the wall is stable. Not real-time safe.
[[nodiscard]] double spectralRadius(const SampledWall& wall, double stiffness_N_per_m);

/// Upper end of the first interval of stiffness in which the wall is stable [N/m], by scan and bisection; 0 if there is
/// none, infinity if it does not end below 1e8 N/m. Not real-time safe.
[[nodiscard]] double criticalStiffness(const SampledWall& wall);

} // namespace palpate
