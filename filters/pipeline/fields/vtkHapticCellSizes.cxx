// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticCellSizes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "vtkDataSet.h"

using palpate::Vec3;

namespace
{
constexpr double pointsInBin = 64.0; // so few more by chance do not look like smaller cells
constexpr int mostAlongAxis = 256;
} // namespace

vtkHapticCellSizes::vtkHapticCellSizes(const std::vector<vtkDataSet*>& parts, const std::array<double, 6>& bounds_u)
{
  this->Bins.low = Vec3(bounds_u[0], bounds_u[2], bounds_u[4]);
  const Vec3 lengths = Vec3(bounds_u[1], bounds_u[3], bounds_u[5]) - this->Bins.low;
  double points = 0.0;
  for (vtkDataSet* part : parts)
  {
    points += static_cast<double>(part->GetNumberOfPoints());
  }
  const double edge_u = std::cbrt(lengths.prod() * pointsInBin / std::max(points, 1.0));
  for (int k = 0; k < 3; ++k)
  {
    this->Bins.size[k] = static_cast<int>(std::clamp(std::floor(lengths[k] / edge_u), 1.0, 1.0 * mostAlongAxis));
    this->Bins.edge[k] = lengths[k] / this->Bins.size[k];
  }
  this->Counts.resize(this->Bins.count());
  this->Mean = points / static_cast<double>(this->Counts.size());
  Vec3 p_W;
  for (vtkDataSet* part : parts)
  {
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
    {
      part->GetPoint(i, p_W.data());
      this->Most = std::max(this->Most, ++this->Counts[this->Bins.indexOf(this->Bins.cellOf(p_W))]);
    }
  }
}

int vtkHapticCellSizes::HalvingsOf(std::uint32_t count) const
{
  const double halvings = std::round(std::log2(std::max(1.0, count / this->Mean)) / 3.0);
  return std::min(mostHalvings, static_cast<int>(halvings));
}

int vtkHapticCellSizes::HalvingsAt(const Vec3& p_W) const
{
  std::array<int, 3> first = this->Bins.cellOf(p_W), last = first;
  for (int k = 0; k < 3; ++k)
  {
    first[k] = std::max(0, first[k] - 1);
    last[k] = std::min(this->Bins.size[k] - 1, last[k] + 1);
  }
  std::uint32_t most = 0;
  this->Bins.forEach(first, last, [&](std::size_t bin) { most = std::max(most, this->Counts[bin]); });
  return this->HalvingsOf(most);
}

double vtkHapticCellSizes::Reach() const
{
  return this->HalvingsOf(this->Most) > 0 ? this->Bins.edge.minCoeff() : std::numeric_limits<double>::infinity();
}
