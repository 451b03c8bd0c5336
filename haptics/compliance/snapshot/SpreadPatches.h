// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <span>

#include "haptics/compliance/snapshot/SoftSurface.h"

namespace palpate
{

/// A part of the surface of a soft body that a contact presses with an even pressure, in place of the patch of a
/// vertex.
struct PressedPart
{
  std::uint32_t at = 0; ///< forces on this vertex act on the part, whose mean displacement is the vertex's
  std::vector<std::uint32_t> vertices; ///< of the part
  std::vector<double> shares;          ///< of the force on each, above 0, which add up to 1
};

/// The patches of a surface under contacts of some width: each as wide as its edges require, and at least as wide as
/// `spread_u`. Made on demand. Used by a worker.
class SpreadPatches
{
public:
  /// The surface is kept by reference.
  SpreadPatches(const SoftSurface& surface, double spread_u) : surface_(surface), spread_u_(spread_u) {}

  [[nodiscard]] double radiusOf(std::uint32_t vertex) const;
  /// Radii of the patches within that of a vertex, each twice the one before, from the radius that its edges require.
  [[nodiscard]] std::vector<double> radiiWithin(std::uint32_t vertex) const;

  /// Three columns per vertex, as of SurfaceMap.
  [[nodiscard]] SparseColumns columnsOf(std::span<const std::uint32_t> vertices);
  void addForce(std::uint32_t vertex, const Vec3& force_N, Eigen::VectorXd& ofNodes);
  /// One column each, along the vertices' normals: radiiWithin() of the first vertex, then those of the next.
  [[nodiscard]] SparseColumns columnsWithin(std::span<const std::uint32_t> vertices, std::span<const Vec3> normals);

private:
  [[nodiscard]] std::uint32_t place(std::uint32_t vertex);

  const SoftSurface& surface_;
  double spread_u_;
  std::map<std::uint32_t, std::uint32_t> placeOf_; ///< of the vertices made so far
  SurfaceMap map_;
};

/// Displacements of patches, one number for each column, for those of the nodes: three numbers per node [u].
[[nodiscard]] Eigen::VectorXd timesColumns(const SparseColumns& patches, const Eigen::VectorXd& ofNodes);

} // namespace palpate
