// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace palpate::lab
{

/// The lever of docs/theory.md, "Constraints between bodies": a needle in a hand, through a hole in a wall and one in
/// an organ, which are springs. Forces are those of wall and organ on the needle, across it.
struct Lever
{
  using Two = Eigen::Vector2d; ///< of the wall and the organ

  double turning_Nm_per_rad = 0.0; ///< of the hand's spring against turns
  Two stiffness_N_per_m{ 500.0, 200.0 };
  Two place_m{ 0.05, 0.15 }; ///< along the needle

  /// Where the energy of hand, wall and organ is stationary on the finite turn [N], by Newton's method from scratch.
  [[nodiscard]] Two forceOfTurn_N(double hand_m) const;
  /// The same for small turns [N].
  [[nodiscard]] Two forceByEnergy_N(double hand_m) const;
  /// The force of each spot as if there were no other [N].
  [[nodiscard]] Two forceBySpot_N(double hand_m) const;
};

} // namespace palpate::lab
