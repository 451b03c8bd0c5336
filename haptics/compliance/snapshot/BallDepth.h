// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "haptics/compliance/snapshot/ComplianceSnapshot.h"
#include "haptics/compliance/snapshot/LayerCompliance.h"

namespace palpate
{

/// A patch around a point, and its displacement along its normal under a force on itself.
struct PatchRung
{
  double radius_u = 0.0;
  double compliance = 0.0; ///< [u/N]
};

/// Depth of a ball in a surface under a force, from the compliance of the patches around the contact.
///
/// Pressure is taken as a paraboloid, whose radius makes the complementary energy W(a) F^2 / 2 + F G(a) stationary:
/// W(a) is the compliance of a patch of that radius, G(a) the mean gap of the sphere over it. The depth is
/// .15 % off Hertz, which is corrected, and exact for a layer much thinner than the contact is wide. Between the
/// patches, and below the smallest, compliance is that of a layer (LayerCompliance). Used by a worker.
class BallDepth
{
public:
  /// `modulus`: E* [N/u^2]; `edge_u`: of the mesh at the point; `rungs`: of ascending width, the last is the snapshot's
  /// patch.
  BallDepth(
    const LayerCompliance& layer, double ball_u, double modulus, double edge_u, const std::vector<PatchRung>& rungs);

  /// Cube root of the force up to which the ball's contact stays within the last patch, and within the ball.
  [[nodiscard]] double lastRoot() const { return this->root_.back(); }
  /// Radius of the paraboloid of pressure under a force [u].
  [[nodiscard]] double contactUnder(double force_N) const;
  /// Depth of the ball beyond the last patch, with this distance of the knots.
  [[nodiscard]] SubgridSpring springOf(double step) const;

private:
  [[nodiscard]] double beyondPatch(double root) const;

  SubgridSpring law_;           ///< for small forces
  double patch_ = 0.0;          ///< compliance of the last patch
  std::vector<double> root_;    ///< cube root of the force, at contacts of ascending width
  std::vector<double> depth_u_; ///< of the ball there
  std::vector<double> width_u_; ///< of the contact there
};

} // namespace palpate
