// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace palpate
{

/// The narrowest corridor, between walls as thick as itself, in which a hand can tell where it is [m of the device]:
/// 2 force / stiffness. A hand that presses with that force stands force / stiffness behind the wall. Half a wall deep
/// the hand is as near to the next corridor as to its own. Stiffness > 0.
[[nodiscard]] constexpr double smallestFeature_m(double force_N, double stiffness_N_per_m) noexcept
{
  return 2.0 * force_N / stiffness_N_per_m;
}

/// By how much a scene must be enlarged, at least 1, so that a hand that presses with that force can tell a corridor
/// from the next one. The corridor is `width_m` > 0 wide under the hand.
[[nodiscard]] constexpr double zoomToFeel(double width_m, double force_N, double stiffness_N_per_m) noexcept
{
  const double zoom = smallestFeature_m(force_N, stiffness_N_per_m) / width_m;
  return zoom > 1.0 ? zoom : 1.0;
}

} // namespace palpate
