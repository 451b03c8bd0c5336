// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/snapshot/ComplianceCache.h"

#include <algorithm>

namespace palpate
{

bool ComplianceCache::knows(std::uint32_t vertex) const
{
  return std::ranges::find(this->vertices_, vertex) != this->vertices_.end();
}

Eigen::Index ComplianceCache::rowOf(std::uint32_t vertex) const
{
  return 3 * (std::ranges::find(this->vertices_, vertex) - this->vertices_.begin());
}

std::vector<std::uint32_t> ComplianceCache::learn(const std::vector<std::uint32_t>& wanted, std::size_t most)
{
  std::vector<std::uint32_t> known;
  std::vector<std::uint32_t> unknown;
  for (const std::uint32_t vertex : wanted)
  {
    const bool isNew = !this->knows(vertex);
    if (!isNew || this->vertices_.empty() || unknown.size() < most)
    {
      known.push_back(vertex);
      unknown.insert(unknown.end(), isNew ? 1 : 0, vertex);
    }
  }
  if (!unknown.empty())
  {
    std::vector<std::uint32_t> kept;
    std::ranges::copy_if(known, std::back_inserter(kept), [this](std::uint32_t v) { return this->knows(v); });
    for (const std::uint32_t vertex : this->vertices_)
    {
      if (kept.size() + unknown.size() < mostKnown && std::ranges::find(kept, vertex) == kept.end())
      {
        kept.push_back(vertex);
      }
    }
    this->blocks_ = this->between(kept);
    this->vertices_ = std::move(kept);
    this->add(unknown);
  }
  return known;
}

void ComplianceCache::add(const std::vector<std::uint32_t>& unknown)
{
  const auto before = static_cast<Eigen::Index>(3 * this->vertices_.size());
  const auto more = static_cast<Eigen::Index>(3 * unknown.size());
  this->vertices_.insert(this->vertices_.end(), unknown.begin(), unknown.end());
  const SparseColumns all = this->patches_.columnsOf(this->vertices_);
  if (before == 0)
  {
    this->blocks_ = this->body_.compliance(all);
    return;
  }
  const Eigen::MatrixXd columns = this->body_.compliance(all, this->patches_.columnsOf(unknown));
  this->blocks_.conservativeResize(before + more, before + more);
  this->blocks_.bottomLeftCorner(more, before) = columns.topRows(before).transpose();
  // Of what rounding makes of the pairs among the new ones, one half counts.
  this->blocks_.bottomRightCorner(more, more) = columns.bottomRows(more).selfadjointView<Eigen::Lower>();
  this->blocks_.topRightCorner(before, more) = columns.topRows(before);
}

Eigen::MatrixXd ComplianceCache::between(const std::vector<std::uint32_t>& vertices) const
{
  const auto count = static_cast<Eigen::Index>(vertices.size());
  std::vector<Eigen::Index> rows;
  std::ranges::transform(vertices, std::back_inserter(rows), [this](std::uint32_t v) { return this->rowOf(v); });
  Eigen::MatrixXd found(3 * count, 3 * count);
  for (Eigen::Index j = 0; j < count; ++j)
  {
    for (Eigen::Index i = 0; i < count; ++i)
    {
      found.block<3, 3>(3 * i, 3 * j) =
        this->blocks_.block<3, 3>(rows[static_cast<std::size_t>(i)], rows[static_cast<std::size_t>(j)]);
    }
  }
  return found;
}

} // namespace palpate
