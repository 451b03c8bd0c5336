// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/snapshot/ComplianceCache.h"

#include <algorithm>

#include "haptics/compliance/body/KeptInverse.h"

namespace palpate
{
namespace
{

/// Factor by which the columns of some vertices cost more than their share in the compliance of all, which takes no
/// backward solve and half of the product.
constexpr std::size_t moreThanAllOf = 2;

} // namespace

bool ComplianceCache::knows(std::uint32_t vertex) const
{
  return std::ranges::find(this->vertices_, vertex) != this->vertices_.end();
}

Eigen::Index ComplianceCache::rowOf(std::uint32_t vertex) const
{
  return 3 * (std::ranges::find(this->vertices_, vertex) - this->vertices_.begin());
}

std::vector<std::uint32_t> ComplianceCache::unknownOf(const std::vector<std::uint32_t>& wanted) const
{
  std::vector<std::uint32_t> unknown;
  std::ranges::copy_if(wanted, std::back_inserter(unknown), [this](std::uint32_t v) { return !this->knows(v); });
  return unknown;
}

std::vector<std::uint32_t> ComplianceCache::learn(
  const std::vector<std::uint32_t>& wanted, std::size_t most, const KeptInverse* kept)
{
  std::vector<std::uint32_t> unknown = this->unknownOf(wanted);
  if (unknown.empty())
  {
    return wanted;
  }
  if (kept && !kept->knows(this->patches_.columnsOf(this->vertices_)))
  {
    this->makeRoom(wanted, mostKnown); // drops those that it could not pair with the new ones
  }
  const bool all = kept || this->vertices_.empty() || unknown.size() <= most;
  if (!all)
  {
    unknown.resize(most);
  }
  if (all && !kept && moreThanAllOf * unknown.size() > wanted.size())
  {
    unknown = wanted;
    this->forget();
  }
  std::vector<std::uint32_t> known;
  std::ranges::copy_if(wanted, std::back_inserter(known),
    [&](std::uint32_t v) { return this->knows(v) || std::ranges::find(unknown, v) != unknown.end(); });
  if (!unknown.empty())
  {
    this->makeRoom(known, unknown.size());
    this->add(unknown, kept);
  }
  return known;
}

/// Forgets the oldest vertices that are not wanted.
void ComplianceCache::makeRoom(const std::vector<std::uint32_t>& wanted, std::size_t more)
{
  std::vector<std::uint32_t> left;
  std::ranges::copy_if(wanted, std::back_inserter(left), [this](std::uint32_t v) { return this->knows(v); });
  for (const std::uint32_t vertex : this->vertices_)
  {
    if (left.size() + more < mostKnown && std::ranges::find(left, vertex) == left.end())
    {
      left.push_back(vertex);
    }
  }
  this->blocks_ = this->between(left);
  this->vertices_ = std::move(left);
}

void ComplianceCache::add(const std::vector<std::uint32_t>& unknown, const KeptInverse* kept)
{
  const auto before = static_cast<Eigen::Index>(3 * this->vertices_.size());
  const auto more = static_cast<Eigen::Index>(3 * unknown.size());
  this->vertices_.insert(this->vertices_.end(), unknown.begin(), unknown.end());
  const SparseColumns all = this->patches_.columnsOf(this->vertices_);
  if (before == 0 && !kept)
  {
    this->blocks_ = this->body_.compliance(all);
    return;
  }
  const SparseColumns added = this->patches_.columnsOf(unknown);
  const Eigen::MatrixXd columns = kept ? kept->compliance(all, added) : this->body_.compliance(all, added);
  this->blocks_.conservativeResize(before + more, before + more);
  this->blocks_.bottomLeftCorner(more, before) = columns.topRows(before).transpose();
  // The pairs among the new ones are asymmetric by rounding: one half counts.
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
