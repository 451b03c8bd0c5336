// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace palpate
{

/// One place of a line.
struct LinePlace
{
  double s_m = 0.0;         ///< along the line, as far as the hand turns
  double potential_J = 0.0; ///< potential: the hand is drawn downhill
  double friction_N = 0.0;  ///< that holds it there
};

/// A world of one dimension, for hands that turn a wheel: a value along a path as hills and hollows, detents, friction
/// from place to place, and a stop at either end.
struct LineWorld
{
  std::vector<LinePlace> places; ///< ascending; between them potential and friction are interpolated
  double detentEvery_m = 0.0;    ///< one at each multiple of it; 0: none
  double detent_N = 0.0;         ///< largest force of a detent, half way to the next one
  double stop_N_per_m = 200.0; ///< of the springs beyond the first and the last place, and of friction before it slides

  /// The stiffest spring in it [N/m].
  [[nodiscard]] double stiffest_N_per_m() const noexcept;
  /// Empty, or one sentence why it cannot be felt: places, numbers, or stiffer than `largest_N_per_m`.
  [[nodiscard]] std::string refusal(double largest_N_per_m) const;
};

/// Force on a hand at s_m along the line, without friction [N]:
///
///     -dV/ds - k_d (s - nearest detent) + k (stop - s) beyond a stop,    k_d = 2 detent_N / detentEvery_m
///
/// Over a closed path the force does no work. The world must not be refused. Real-time safe; a binary search.
[[nodiscard]] double lineForce(const LineWorld& world, double s_m) noexcept;

/// Coulomb's friction as a spring to an anchor that follows once it is stretched to the friction of the place: at rest
/// it holds, and it never gives work. Moves the anchor; returns the force [N]. Real-time safe. (Dahl 1968)
[[nodiscard]] double lineFriction(const LineWorld& world, double s_m, double& anchor_m) noexcept;

} // namespace palpate
