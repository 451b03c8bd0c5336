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

/// How far a point is outside: 0 within, else the way past the faces by the tetrahedron's own heights, as a length.
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
  // About one tetrahedron a cell.
  const double side = std::cbrt(std::max(all.volume(), 1e-300) / static_cast<double>(mesh.tetras.size()));
  this->low_W_ = all.min();
  for (int axis = 0; axis < 3; ++axis)
  {
    this->counts_[axis] = std::clamp(static_cast<int>(all.sizes()[axis] / side), 1, 64);
    this->cell_u_[axis] = std::max(all.sizes()[axis] / this->counts_[axis], std::numeric_limits<double>::min());
  }
  this->cells_.resize(static_cast<std::size_t>(this->counts_[0]) * this->counts_[1] * this->counts_[2]);
  for (std::uint32_t i = 0; i < mesh.tetras.size(); ++i)
  {
    const Eigen::AlignedBox3d box = boxOf(mesh, mesh.tetras[i]);
    const Cell low = this->cellOf(box.min());
    const Cell high = this->cellOf(box.max());
    for (Cell c = low; c[2] <= high[2]; ++c[2])
    {
      for (c[1] = low[1]; c[1] <= high[1]; ++c[1])
      {
        for (c[0] = low[0]; c[0] <= high[0]; ++c[0])
        {
          this->cells_[this->indexOf(c)].push_back(i);
        }
      }
    }
  }
}

TetraSearch::Cell TetraSearch::cellOf(const Vec3& p_W) const
{
  Cell cell{};
  for (int axis = 0; axis < 3; ++axis)
  {
    const double place = (p_W[axis] - this->low_W_[axis]) / this->cell_u_[axis];
    cell[axis] = static_cast<int>(std::clamp(place, 0.0, this->counts_[axis] - 1.0));
  }
  return cell;
}

std::size_t TetraSearch::indexOf(const Cell& cell) const
{
  return (static_cast<std::size_t>(cell[2]) * this->counts_[1] + cell[1]) * this->counts_[0] + cell[0];
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
      best = { i, weights, outside <= 1e-9 * this->cell_u_.norm() };
    }
  }
}

TetraPlace TetraSearch::find(const Vec3& p_W) const
{
  TetraPlace best;
  double distance = std::numeric_limits<double>::infinity();
  const Cell center = this->cellOf(p_W);
  this->lookAt(this->cells_[this->indexOf(center)], p_W, best, distance);
  // What is outside is near one of the border's tetrahedra: shells of cells around, one beyond the first find.
  const int most = *std::max_element(this->counts_.begin(), this->counts_.end());
  int beyond = 1;
  for (int shell = 1; shell < most && !best.inside && beyond >= 0; ++shell)
  {
    for (std::size_t c = 0; c < this->cells_.size(); ++c)
    {
      const auto [x, y, z] =
        Cell{ static_cast<int>(c) % this->counts_[0], static_cast<int>(c) / this->counts_[0] % this->counts_[1],
          static_cast<int>(c) / this->counts_[0] / this->counts_[1] };
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
