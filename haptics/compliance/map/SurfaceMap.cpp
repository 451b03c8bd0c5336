// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/map/SurfaceMap.h"

#include <algorithm>

#include "haptics/compliance/map/TetraSearch.h"

namespace palpate
{

void SurfaceMap::add(const NodeBlocks& point)
{
  this->nodes_.insert(this->nodes_.end(), point.nodes.begin(), point.nodes.end());
  this->blocks_.insert(this->blocks_.end(), point.blocks.begin(), point.blocks.end());
  this->start_.push_back(this->nodes_.size());
}

Vec3 SurfaceMap::displacementOf(std::size_t point, const Eigen::VectorXd& ofNodes) const
{
  Vec3 u = Vec3::Zero();
  for (std::size_t i = this->start_[point]; i < this->start_[point + 1]; ++i)
  {
    u += this->blocks_[i] * ofNodes.segment<3>(3 * static_cast<Eigen::Index>(this->nodes_[i]));
  }
  return u;
}

void SurfaceMap::addForce(std::size_t point, const Vec3& force_N, Eigen::VectorXd& ofNodes) const
{
  for (std::size_t i = this->start_[point]; i < this->start_[point + 1]; ++i)
  {
    ofNodes.segment<3>(3 * static_cast<Eigen::Index>(this->nodes_[i])) += this->blocks_[i].transpose() * force_N;
  }
}

SparseColumns SurfaceMap::columnsOf(std::span<const std::uint32_t> points) const
{
  SparseColumns columns;
  for (const std::uint32_t point : points)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      for (std::size_t i = this->start_[point]; i < this->start_[point + 1]; ++i)
      {
        for (int c = 0; c < 3; ++c)
        {
          columns.rows.push_back(static_cast<std::int32_t>(3 * this->nodes_[i]) + c);
          columns.values.push_back(this->blocks_[i](axis, c));
        }
      }
      columns.start.push_back(columns.rows.size());
    }
  }
  return columns;
}

namespace
{

/// Upper bound of a point's distance from the tetrahedron: the distance from the point of its weights that are above 0.
double mostDistance_u(const TetraMesh& mesh, const TetraPlace& place, const Vec3& p_W)
{
  Vec3 within = Vec3::Zero();
  double sum = 0.0;
  for (int a = 0; a < 4; ++a)
  {
    const double weight = std::max(place.weights[a], 0.0);
    within += weight * mesh.vertices_W[mesh.tetras[place.tetra][a]];
    sum += weight;
  }
  return (p_W - within / sum).norm();
}

} // namespace

Embedding embed(const TetraMesh& mesh, const std::vector<Vec3>& points_W)
{
  Embedding embedding;
  const TetraSearch search(mesh);
  for (const Vec3& p : points_W)
  {
    const TetraPlace place = search.find(p);
    if (!place.inside)
    {
      ++embedding.outside;
      embedding.farthest_u = std::max(embedding.farthest_u, mostDistance_u(mesh, place, p));
    }
    NodeBlocks blocks;
    for (int a = 0; a < 4; ++a)
    {
      blocks.nodes.push_back(mesh.tetras[place.tetra][a]);
      blocks.blocks.emplace_back(place.weights[a] * Mat3::Identity());
    }
    embedding.map.add(blocks);
  }
  return embedding;
}

} // namespace palpate
