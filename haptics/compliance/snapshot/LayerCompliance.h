// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>
#include <vector>

namespace palpate
{

/// In units of 1 / (E* a): compliance of a half space under a patch's paraboloid of force, in the patch's own mean.
inline constexpr double halfSpaceOfPatch = 2048.0 / (315.0 * std::numbers::pi * std::numbers::pi);

/// Compliance below a patch, modelled as a layer on a rigid base: the one number `stiffening` is the difference
/// from a half space for every radius of the patch. 0 is the half space; above 0 it is 1 over the layer's
/// thickness (Burmister 1945, bonded to the base); below 0, where a body bends, the compliance has a constant addition.
/// Used by a worker.
class LayerCompliance
{
public:
  explicit LayerCompliance(double poisson);

  /// Compliance of a patch of this radius on E* = 1.
  [[nodiscard]] double of(double radius_u, double stiffening) const;
  /// The inverse, for a compliance that was found for a patch on edges of some length: tetrahedra have a little less
  /// compliance than a half space under a patch of a few edges.
  [[nodiscard]] double stiffeningOf(double radius_u, double compliance, double edge_u) const;

private:
  [[nodiscard]] double lackAt(double radiusInLayers) const;

  /// Reduction of the half space's compliance by a layer, times its thickness over the radius: over the logarithm of
  /// the radius in thicknesses, in equal steps.
  std::vector<double> lack_;
};

} // namespace palpate
