// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>
#include <vector>

namespace palpate
{

/// Of 1 / (E* a): compliance of a half space under a patch's paraboloid of force, in the patch's own mean.
inline constexpr double halfSpaceOfPatch = 2048.0 / (315.0 * std::numbers::pi * std::numbers::pi);

/// Compliance below a patch, modelled as a layer on a rigid base: with the one number `stiffening` it is
/// told apart from a half space, whatever the patch's radius is. 0 is the half space; above 0 it is 1 over the layer's
/// thickness (Burmister 1945, the base holds the layer); below 0, where a body bends, it is as much softer everywhere.
/// A worker's.
class LayerCompliance
{
public:
  explicit LayerCompliance(double poisson);

  /// Of a patch of radius 1 on E* = 1.
  [[nodiscard]] double of(double radius_u, double stiffening) const;
  /// The inverse, of a compliance that was found for a patch on edges of some length: tetrahedra lack a little of what
  /// they would answer a patch of a few edges with on a half space.
  [[nodiscard]] double stiffeningOf(double radius_u, double compliance, double edge_u) const;

private:
  [[nodiscard]] double lackAt(double radiusInLayers) const;

  /// Reduction of the half space's compliance by a layer, times its thickness over the radius: over the logarithm of
  /// the radius in thicknesses, in equal steps.
  std::vector<double> lack_;
};

} // namespace palpate
