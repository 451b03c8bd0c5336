// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "haptics/compliance/material/ElasticLaw.h"
#include "haptics/compliance/mesh/TetraMesh.h"

namespace palpate
{

/// Discretisation of strain. Kinds differ only in their list of points.
enum class ElementKind : std::uint8_t
{
  Linear,       ///< one point per tetrahedron; far too stiff in bending
  EdgeSmoothed, ///< one point per edge and material around it: no new nodes, true to 2 % with four across a bar
  Quadratic,    ///< ten nodes and four points per tetrahedron: also for nearly incompressible materials
};

/// A point of strain: F = sum over its nodes of x_a g_a^T, for a volume.
struct StrainPoint
{
  std::size_t first = 0; ///< index of its nodes and gradients
  std::size_t count = 0;
  double volume_u3 = 0.0;
  ElasticModuli moduli;
};

/// Nodes at rest and all points of a body.
struct StrainPoints
{
  std::vector<Vec3> rest_W; ///< [u]; the mesh's vertices come first
  std::vector<StrainPoint> points;
  std::vector<std::uint32_t> nodes;
  std::vector<Vec3> gradients; ///< [1/u]
  /// For each further node, the ends of the edge that it halves.
  std::vector<std::array<std::uint32_t, 2>> halves;
  std::vector<std::uint32_t> ofTetras; ///< the points of each tetrahedron, one tetrahedron after another
  std::size_t perTetra = 0;            ///< points of one: all have as many

  [[nodiscard]] std::span<const std::uint32_t> nodesOf(const StrainPoint& p) const
  {
    return { this->nodes.data() + p.first, p.count };
  }
  [[nodiscard]] std::span<const Vec3> gradientsOf(const StrainPoint& p) const
  {
    return { this->gradients.data() + p.first, p.count };
  }
  /// Bytes of a stiffness in which every pair of nodes of every point has a block of its own: an upper bound of the
  /// real size.
  [[nodiscard]] std::size_t mostStiffnessBytes() const;
  /// `displacement`: three numbers per node [u].
  [[nodiscard]] Mat3 deformationAt(const StrainPoint& p, std::span<const double> displacement) const;
  /// F of each tetrahedron: the mean of its points, `ofPoints` in their order. For quadratic tetrahedra that is their
  /// own mean, for edge-smoothed ones the mean of the smoothed strains around their edges, which converges where the
  /// gradient of their corners alone has an error of its own size.
  [[nodiscard]] std::vector<Mat3> deformationOfTetras(const std::vector<Mat3>& ofPoints) const;
};

/// For a checked mesh; `moduli`: of each tetrahedron. Edge-smoothed strain: Liu & Nguyen-Thoi 2010; it is smoothed
/// within one material each (Materials.h), so that a step of the modulus stays a step.
[[nodiscard]] StrainPoints makeStrainPoints(
  const TetraMesh& mesh, ElementKind kind, const std::vector<ElasticModuli>& moduli);

} // namespace palpate
