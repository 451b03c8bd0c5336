// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "haptics/compliance/mesh/TetraMesh.h"
#include "haptics/compliance/solve/SparseColumns.h"

namespace palpate
{

/// How a point of a surface follows the nodes of a body: u = sum of block_i u_node(i). The blocks of a turned or
/// moved body turn or move it along; forces go back by the transpose, so force, moment and power are kept.
struct NodeBlocks
{
  std::vector<std::uint32_t> nodes;
  std::vector<Mat3> blocks;
};

/// The maps of many points, one behind the other.
class SurfaceMap
{
public:
  void add(const NodeBlocks& point);

  [[nodiscard]] std::size_t size() const { return this->start_.size() - 1; }
  /// `ofNodes`: three numbers a node [u].
  [[nodiscard]] Vec3 displacementOf(std::size_t point, const Eigen::VectorXd& ofNodes) const;
  /// Adds the nodal forces of a force on a point [N].
  void addForce(std::size_t point, const Vec3& force_N, Eigen::VectorXd& ofNodes) const;
  /// Three columns a point, on the numbers 3 node + axis: the input of SoftBody::compliance.
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
  std::size_t outside = 0; ///< points in no tetrahedron: they follow the nearest one, continued beyond its faces
  double farthest_u = 0.0; ///< none of them is further from the tetrahedra
};

[[nodiscard]] Embedding embed(const TetraMesh& mesh, const std::vector<Vec3>& points_W);

} // namespace palpate
