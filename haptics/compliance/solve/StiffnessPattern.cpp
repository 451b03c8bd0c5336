// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/solve/StiffnessPattern.h"

#include <algorithm>
#include <iterator>

namespace palpate
{
namespace
{

/// For each free node, the free nodes of higher number that share a point with it.
std::vector<std::vector<std::int32_t>> higherNeighbours(
  const StrainPoints& body, const std::vector<std::int32_t>& numbers, std::size_t count)
{
  std::vector<std::vector<std::int32_t>> below(count);
  for (const StrainPoint& point : body.points)
  {
    for (const std::uint32_t a : body.nodesOf(point))
    {
      for (const std::uint32_t b : body.nodesOf(point))
      {
        if (numbers[b] >= 0 && numbers[a] > numbers[b])
        {
          below[static_cast<std::size_t>(numbers[b])].push_back(numbers[a]);
        }
      }
    }
  }
  for (std::vector<std::int32_t>& list : below)
  {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return below;
}

} // namespace

Eigen::VectorXd SparseLower::times(const Eigen::VectorXd& x) const
{
  Eigen::VectorXd y = Eigen::VectorXd::Zero(x.size());
  for (int column = 0; column < this->order(); ++column)
  {
    y[column] += this->values[this->start[column]] * x[column];
    for (int i = this->start[column] + 1; i < this->start[column + 1]; ++i)
    {
      y[this->rows[i]] += this->values[i] * x[column];
      y[column] += this->values[i] * x[this->rows[i]];
    }
  }
  return y;
}

StiffnessPattern::StiffnessPattern(const StrainPoints& body, std::vector<std::int32_t> numbers)
  : numbers_(std::move(numbers))
{
  const auto count = static_cast<std::size_t>(
    std::count_if(this->numbers_.begin(), this->numbers_.end(), [](std::int32_t n) { return n >= 0; }));
  const auto below = higherNeighbours(body, this->numbers_, count);
  this->columnStart_.push_back(0);
  for (int node = 0; node < static_cast<int>(count); ++node)
  {
    for (int c = 0; c < 3; ++c)
    {
      for (int r = c; r < 3; ++r)
      {
        this->rows_.push_back(3 * node + r);
      }
      for (const std::int32_t other : below[node])
      {
        this->rows_.insert(this->rows_.end(), { 3 * other, 3 * other + 1, 3 * other + 2 });
      }
      this->columnStart_.push_back(static_cast<int>(this->rows_.size()));
    }
  }
  this->findSlots(body, below);
}

void StiffnessPattern::findSlots(const StrainPoints& body, const std::vector<std::vector<std::int32_t>>& below)
{
  for (const StrainPoint& point : body.points)
  {
    this->firstSlot_.push_back(this->slots_.size());
    const auto nodes = body.nodesOf(point);
    for (std::size_t a = 0; a < nodes.size(); ++a)
    {
      for (std::size_t b = 0; b <= a; ++b)
      {
        const auto [column, row] = std::minmax(this->numbers_[nodes[a]], this->numbers_[nodes[b]]);
        std::int32_t slot = 0;
        if (column >= 0 && row > column)
        {
          const auto& list = below[static_cast<std::size_t>(column)];
          slot = static_cast<std::int32_t>(std::lower_bound(list.begin(), list.end(), row) - list.begin());
        }
        this->slots_.push_back(slot);
      }
    }
  }
}

SparseLower StiffnessPattern::zeros() const
{
  return { this->columnStart_, this->rows_, std::vector<double>(this->rows_.size(), 0.0) };
}

void StiffnessPattern::addBlock(
  SparseLower& k, std::int32_t slot, std::int32_t row, std::int32_t column, const Mat3& block) const
{
  for (int c = 0; c < 3; ++c)
  {
    double* const values = k.values.data() + this->columnStart_[3 * column + c];
    if (row == column)
    {
      for (int r = c; r < 3; ++r)
      {
        values[r - c] += block(r, c);
      }
      continue;
    }
    for (int r = 0; r < 3; ++r)
    {
      values[3 - c + 3 * slot + r] += block(r, c);
    }
  }
}

void StiffnessPattern::add(
  SparseLower& k, const StrainPoints& body, std::size_t point, const StressDerivative& stiffness) const
{
  const StrainPoint& p = body.points[point];
  const auto nodes = body.nodesOf(p);
  std::vector<Vec3> gradients;
  std::ranges::transform(body.gradientsOf(p), std::back_inserter(gradients),
    [&stiffness](const Vec3& g) { return Vec3(stiffness.v.transpose() * g); });
  std::size_t slot = this->firstSlot_[point];
  for (std::size_t a = 0; a < nodes.size(); ++a)
  {
    const Vec3 weighed = p.volume_u3 * gradients[a];
    for (std::size_t b = 0; b <= a; ++b, ++slot)
    {
      const std::int32_t row = this->numbers_[nodes[a]];
      const std::int32_t column = this->numbers_[nodes[b]];
      if (row < 0 || column < 0)
      {
        continue;
      }
      const Mat3 block = stiffness.between(weighed, gradients[b]);
      if (row >= column)
      {
        this->addBlock(k, this->slots_[slot], row, column, block);
      }
      else
      {
        this->addBlock(k, this->slots_[slot], column, row, block.transpose());
      }
    }
  }
}

} // namespace palpate
