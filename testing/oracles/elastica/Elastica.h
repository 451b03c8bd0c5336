// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace palpate::test
{

/// The tip of a rod of length 1 that is clamped along x and loaded across, along y, at its free end.
struct CantileverTip
{
  double across = 0.0;
  double shorter = 0.0; ///< how much nearer to the clamp it is along x
  double angle_rad = 0.0;
};

/// Of a thin rod that does not stretch, by its load times its length squared over its stiffness against bending. With k
/// = sin(angle / 2 + pi / 4) and sin f = 1 / (k sqrt 2) the load is (K(k) - F(f, k))^2 (Bisshopp & Drucker 1945).
[[nodiscard]] CantileverTip cantileverTip(double load);

/// Force that holds a thin rod with pinned ends so much shorter than it is, over the one at which it buckles: (2 K(k) /
/// pi)^2, where the chord is 2 E(k) / K(k) - 1 (Love 1927, 263).
[[nodiscard]] double columnForce(double shortening);

} // namespace palpate::test
