// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "haptics/force/LinearPlant.h"

namespace palpate
{

/// m x'' + b x' + k x + c sgn(x') = u along one axis, u constant over each period. Exact between reversals: the moment
/// at which the speed passes zero is found by halving the exact step, to 2^-20 of a millisecond; there friction
/// balances a pull below c, and never reverses a motion by itself.
class FrictionPlant
{
public:
  /// One whose state is 0 after a period.
  FrictionPlant() = default;
  FrictionPlant(double mass_kg, double damping_Ns_per_m, double stiffness_N_per_m, double friction_N, double period_s);

  struct State
  {
    double x_m = 0.0;
    double v_m_per_s = 0.0;
  };

  /// One period under force u [N]. Real-time safe.
  void step(State& s, double u_N) const noexcept;

private:
  void stepPart(State& s, double u_N) const noexcept;
  [[nodiscard]] static State after(const LinearPlant& plant, const State& s, double u_N) noexcept;
  /// Moves on in direction `way` with friction until the speed passes zero or the part ends; true when it ends.
  [[nodiscard]] bool slide(State& s, double u_N, double way, long& left) const noexcept;

  double stiffness_N_per_m_ = 0.0;
  double friction_N_ = 0.0;
  int parts_ = 1;                        ///< of a period: each too short for a speed to pass zero twice
  LinearPlant whole_;                    ///< the period at once, without friction
  std::array<LinearPlant, 21> halvings_; ///< a part, half of it, a quarter, ...
};

} // namespace palpate
