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
  : Low(bounds_u[0], bounds_u[2], bounds_u[4])
{
  const Vec3 lengths = Vec3(bounds_u[1], bounds_u[3], bounds_u[5]) - this->Low;
  double points = 0.0;
  for (vtkDataSet* part : parts)
  {
    points += static_cast<double>(part->GetNumberOfPoints());
  }
  const double edge_u = std::cbrt(lengths.prod() * pointsInBin / std::max(points, 1.0));
  for (int k = 0; k < 3; ++k)
  {
    this->Size[k] = static_cast<int>(std::clamp(std::floor(lengths[k] / edge_u), 1.0, 1.0 * mostAlongAxis));
    this->Bin[k] = lengths[k] / this->Size[k];
  }
  this->Counts.resize(static_cast<std::size_t>(this->Size[0]) * this->Size[1] * this->Size[2]);
  this->Mean = points / static_cast<double>(this->Counts.size());
  Vec3 p_W;
  for (vtkDataSet* part : parts)
  {
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
    {
      part->GetPoint(i, p_W.data());
      this->Most = std::max(this->Most, ++this->Counts[this->IndexOf(this->BinOf(p_W))]);
    }
  }
}

std::array<int, 3> vtkHapticCellSizes::BinOf(const Vec3& p_W) const
{
  std::array<int, 3> bin{};
  for (int k = 0; k < 3; ++k)
  {
    const double at = std::floor((p_W[k] - this->Low[k]) / this->Bin[k]);
    bin[k] = static_cast<int>(std::fmin(std::fmax(at, 0.0), this->Size[k] - 1.0));
  }
  return bin;
}

std::size_t vtkHapticCellSizes::IndexOf(const std::array<int, 3>& bin) const
{
  return bin[0] + static_cast<std::size_t>(this->Size[0]) * (bin[1] + static_cast<std::size_t>(this->Size[1]) * bin[2]);
}

int vtkHapticCellSizes::HalvingsOf(std::uint32_t count) const
{
  const double halvings = std::round(std::log2(std::max(1.0, count / this->Mean)) / 3.0);
  return std::min(mostHalvings, static_cast<int>(halvings));
}

int vtkHapticCellSizes::HalvingsAt(const Vec3& p_W) const
{
  const std::array<int, 3> middle = this->BinOf(p_W);
  std::uint32_t most = 0;
  std::array<int, 3> bin{};
  const auto first = [&](int k) { return std::max(0, middle[k] - 1); };
  const auto last = [&](int k) { return std::min(this->Size[k] - 1, middle[k] + 1); };
  for (bin[2] = first(2); bin[2] <= last(2); ++bin[2])
  {
    for (bin[1] = first(1); bin[1] <= last(1); ++bin[1])
    {
      for (bin[0] = first(0); bin[0] <= last(0); ++bin[0])
      {
        most = std::max(most, this->Counts[this->IndexOf(bin)]);
      }
    }
  }
  return this->HalvingsOf(most);
}

double vtkHapticCellSizes::Reach() const
{
  return this->HalvingsOf(this->Most) > 0 ? this->Bin.minCoeff() : std::numeric_limits<double>::infinity();
}
