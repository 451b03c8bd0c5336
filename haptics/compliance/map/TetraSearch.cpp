// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/map/TetraSearch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{

Eigen::AlignedBox3d boxOf(const TetraMesh& mesh, const Tetra& t)
{
  Eigen::AlignedBox3d box;
  for (const std::uint32_t v : t)
  {
    box.extend(mesh.vertices_W[v]);
  }
  return box;
}

std::array<double, 4> weightsIn(const TetraMesh& mesh, const Tetra& t, const Vec3& p_W)
{
  Mat3 edges;
  for (int a = 0; a < 3; ++a)
  {
    edges.col(a) = mesh.vertices_W[t[a + 1]] - mesh.vertices_W[t[0]];
  }
  const Vec3 w = edges.inverse() * (p_W - mesh.vertices_W[t[0]]);
  return { 1.0 - w.sum(), w[0], w[1], w[2] };
}

/// Distance of a point from a tetrahedron: 0 within, else the weights beyond its faces, scaled to a length.
double outsideBy(const TetraMesh& mesh, const Tetra& t, const std::array<double, 4>& weights)
{
  const double least = *std::min_element(weights.begin(), weights.end());
  return std::max(-least, 0.0) * boxOf(mesh, t).diagonal().norm();
}

} // namespace

TetraSearch::TetraSearch(const TetraMesh& mesh) : mesh_(mesh)
{
  Eigen::AlignedBox3d all;
  for (const Vec3& p : mesh.vertices_W)
  {
    all.extend(p);
  }
  // About one tetrahedron per cell.
  const double side = std::cbrt(std::max(all.volume(), 1e-300) / static_cast<double>(mesh.tetras.size()));
  this->grid_.low = all.min();
  for (int axis = 0; axis < 3; ++axis)
  {
    this->grid_.size[axis] = std::clamp(static_cast<int>(all.sizes()[axis] / side), 1, 64);
    this->grid_.edge[axis] = std::max(all.sizes()[axis] / this->grid_.size[axis], std::numeric_limits<double>::min());
  }
  this->cells_.resize(this->grid_.count());
  for (std::uint32_t i = 0; i < mesh.tetras.size(); ++i)
  {
    const Eigen::AlignedBox3d box = boxOf(mesh, mesh.tetras[i]);
    this->grid_.forEach(this->grid_.cellOf(box.min()), this->grid_.cellOf(box.max()),
      [this, i](std::size_t cell) { this->cells_[cell].push_back(i); });
  }
}

void TetraSearch::lookAt(
  const std::vector<std::uint32_t>& tetras, const Vec3& p_W, TetraPlace& best, double& distance) const
{
  for (const std::uint32_t i : tetras)
  {
    const std::array<double, 4> weights = weightsIn(this->mesh_, this->mesh_.tetras[i], p_W);
    const double outside = outsideBy(this->mesh_, this->mesh_.tetras[i], weights);
    if (outside < distance)
    {
      distance = outside;
      best = { i, weights, outside <= 1e-9 * this->grid_.edge.norm() };
    }
  }
}

TetraPlace TetraSearch::find(const Vec3& p_W) const
{
  TetraPlace best;
  double distance = std::numeric_limits<double>::infinity();
  const auto& [width, height, depth] = this->grid_.size;
  const PointGrid::Cell center = this->grid_.cellOf(p_W);
  this->lookAt(this->cells_[this->grid_.indexOf(center)], p_W, best, distance);
  // A point outside is near one of the border's tetrahedra: shells of cells are searched, one beyond the first find.
  const int most = std::max({ width, height, depth });
  int beyond = 1;
  for (int shell = 1; shell < most && !best.inside && beyond >= 0; ++shell)
  {
    for (std::size_t c = 0; c < this->cells_.size(); ++c)
    {
      const int at = static_cast<int>(c), x = at % width, y = at / width % height, z = at / width / height;
      const int away = std::max({ std::abs(x - center[0]), std::abs(y - center[1]), std::abs(z - center[2]) });
      if (away == shell)
      {
        this->lookAt(this->cells_[c], p_W, best, distance);
      }
    }
    beyond -= std::isfinite(distance) ? 1 : 0;
  }
  return best;
}

} // namespace palpate
