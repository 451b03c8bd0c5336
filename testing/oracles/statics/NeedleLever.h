// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "testing/oracles/statics/HeldRod.h"

namespace palpate::test
{

/// The lever of docs/theory.md, "Constraints between bodies": a needle along z in a hand, through a hole in a wall and
/// one in an organ, which are springs. Forces are those of wall and organ on the needle, across it, along y.
struct NeedleLever
{
  using Two = Eigen::Vector2d; ///< of the wall and the organ

  double turning_Nm_per_rad = 0.0; ///< of the hand's spring against turns
  Two stiffness_N_per_m{ 500.0, 200.0 };
  Two place_m{ 0.05, 0.15 }; ///< along the needle
  double coupling_N_per_m = 1000.0;

  [[nodiscard]] HeldRod rod(double hand_m) const;
  /// Where the energy of hand, wall and organ is stationary on the finite turn, by Newton's method from scratch: the
  /// rod's coordinates, then of each hole its place along the shaft and the force there over the hand's spring. Empty:
  /// it does not end.
  [[nodiscard]] Eigen::VectorXd rest(double hand_m) const;
  /// The forces there [N].
  [[nodiscard]] Two forceOfTurn_N(double hand_m) const;
  /// The same for small turns [N].
  [[nodiscard]] Two forceByEnergy_N(double hand_m) const;
  /// The force of each spot as if there were no other [N].
  [[nodiscard]] Two forceBySpot_N(double hand_m) const;
};

} // namespace palpate::test
