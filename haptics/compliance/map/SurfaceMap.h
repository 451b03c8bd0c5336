// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "haptics/compliance/mesh/TetraMesh.h"
#include "haptics/compliance/solve/SparseColumns.h"

namespace palpate
{

/// The map from the nodes of a body to a point of a surface: u = sum of block_i u_node(i). The blocks of a rotated or
/// moved body rotate or move it; forces go back by the transpose, so that force, moment and power are kept.
struct NodeBlocks
{
  std::vector<std::uint32_t> nodes;
  std::vector<Mat3> blocks;
};

/// The maps of many points, in sequence.
class SurfaceMap
{
public:
  void add(const NodeBlocks& point);

  [[nodiscard]] std::size_t size() const { return this->start_.size() - 1; }
  /// `ofNodes`: three numbers per node [u].
  [[nodiscard]] Vec3 displacementOf(std::size_t point, const Eigen::VectorXd& ofNodes) const;
  /// Adds the nodal forces of a force on a point [N].
  void addForce(std::size_t point, const Vec3& force_N, Eigen::VectorXd& ofNodes) const;
  /// Three columns per point, on the numbers 3 node + axis: the input of SoftBody::compliance.
  [[nodiscard]] SparseColumns columnsOf(std::span<const std::uint32_t> points) const;

private:
  std::vector<std::size_t> start_{ 0 };
  std::vector<std::uint32_t> nodes_;
  std::vector<Mat3> blocks_;
};

/// Points in tetrahedra by their barycentric coordinates.
struct Embedding
{
  SurfaceMap map;
  std::size_t outside = 0; ///< points in no tetrahedron: they follow the nearest one, extrapolated beyond its faces
  double farthest_u = 0.0; ///< largest distance of such a point from the tetrahedra
};

[[nodiscard]] Embedding embed(const TetraMesh& mesh, const std::vector<Vec3>& points_W);

} // namespace palpate
