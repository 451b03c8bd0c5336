// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace palpate
{

/// Coulomb friction between ball and surfaces; both 0: none, and no work for it.
struct FrictionPlan
{
  double statical = 0.0; ///< mu_s >= mu_k
  double kinetic = 0.0;  ///< mu_k >= 0

  [[nodiscard]] bool none() const noexcept { return this->statical == 0.0 && this->kinetic == 0.0; }
};

/// The model of contact in a tick, and its work limit. Part of every recording.
struct ContactPlan
{
  double radius_u = 0.0;            ///< ball radius [u], >= 0; 0 is a point
  double coupling_N_per_m = 1000.0; ///< of this tick, which sets it: the reference for soft walls
  FrictionPlan friction;
  /// A ball that is put where a point rests is moved off the face to the exact side of the point; else to the side that
  /// the face is turned to, as in recordings of before.
  bool seatsBySide = false;
  bool shading = false; ///< smooth forces over facets (contact/feel/Shading); its work over a closed way is not zero
  /// Passes of the god-object loop per tick. Settled contact takes 2 or 3. Of 30,000 ticks over a noisy sphere up to 32
  /// met a cap of 32; twice that is allowed.
  std::uint32_t passCap = 64;
  /// Work of a tick (contact/sweep/Work.h), in units of one visited tree node of some 20 ns: 1.2 ms. Beyond it the ball
  /// moves only as far as is proven free.
  std::uint32_t workBudget = 60000;
};

} // namespace palpate
