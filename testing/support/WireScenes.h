// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <numbers>
#include <vector>

#include "haptics/compliance/wire/WireNewton.h"

namespace palpate::test
{

/// A wire with its supports and loads.
struct WireRig
{
  Wire wire;
  WirePlaces places_W;
  WireLoads loads;
  std::unique_ptr<WireNewton> newton = std::make_unique<WireNewton>();

  WireRig(std::span<const Vec3> points_W, const BeamSection& section);
  /// To rest; false if it does not get there.
  bool settle(int mostSteps = 200);
  [[nodiscard]] int last() const { return this->wire.count; }
  [[nodiscard]] const Vec3& tip_W() const { return this->places_W[this->last()].p; }
};

/// From the origin along x.
[[nodiscard]] std::vector<Vec3> straightPoints(int beams, double length);

/// Along a circle of this radius that leaves the origin along x and bends towards y.
[[nodiscard]] std::vector<Vec3> arcPoints(int beams, double radius, double angle_rad);

/// A thin wire of length 1 and bending stiffness 1, whose stretch is negligible.
[[nodiscard]] BeamSection thinSection();

/// A thin wire of length 1, clamped at its first node, with a force across its last one, in units of its stiffness.
[[nodiscard]] WireRig cantilever(int beams, double load);

/// The same with a moment about z that bends it to this share of a circle.
[[nodiscard]] WireRig rolledUp(int beams, double share);

/// A column of 100 mm with pinned ends, of round wire of .25 mm radius and 60 GPa. Units: mm, N.
class PinnedColumn
{
public:
  static constexpr double length_mm = 100.0;
  [[nodiscard]] static BeamSection section();
  /// Euler's: pi^2 E I / L^2.
  [[nodiscard]] static double euler_N();

  explicit PinnedColumn(int beams);
  /// The force at which it stops being stiff while it is straight.
  [[nodiscard]] double buckles_N();
  /// The force that holds it shorter by this share, after a nudge aside.
  [[nodiscard]] double bent_N(double shortening);

private:
  WireRig rig_;
};

/// Bathe & Bolourchi's (1979) bend of 45 degrees: radius 100, a square of 1 x 1, E = 1e7, no transverse contraction,
/// with a force of 600 across its plane. Its torsion is by the polar second moment, 1 / 6, as Simo & Vu-Quoc (1986)
/// have it.
struct BathesBend
{
  static constexpr double radius = 100.0, angle_rad = 0.25 * std::numbers::pi, force = 600.0;
  [[nodiscard]] static BeamSection section();
  /// Of the tip: along the clamped tangent, across it in the plane, along the force.
  [[nodiscard]] static Vec3 tip(int beams);
};

/// A helical spring of a round wire that is pulled by a little along its axis: its stiffness over G d^4 / (8 D^3 n).
[[nodiscard]] double springOverTextbook(int beams, int turns);

} // namespace palpate::test
