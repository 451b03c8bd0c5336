// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace palpate
{

/// Disjoint sets of the numbers below a count, each named by its lowest member. At first every number is a set. Paths
/// are halved (Tarjan & van Leeuwen, Worst-case analysis of set union algorithms, 1984).
class DisjointSets
{
public:
  explicit DisjointSets(std::size_t count) : parent_(count)
  {
    std::iota(this->parent_.begin(), this->parent_.end(), 0u);
  }

  [[nodiscard]] std::uint32_t of(std::uint32_t i)
  {
    while (this->parent_[i] != i)
    {
      i = this->parent_[i] = this->parent_[this->parent_[i]];
    }
    return i;
  }

  void join(std::uint32_t a, std::uint32_t b)
  {
    const auto [low, high] = std::minmax({ this->of(a), this->of(b) });
    this->parent_[high] = low;
  }

  /// The set of every number.
  [[nodiscard]] std::vector<std::uint32_t> all()
  {
    for (std::uint32_t i = 0; i < this->parent_.size(); ++i)
    {
      this->parent_[i] = this->of(i);
    }
    return this->parent_;
  }

private:
  std::vector<std::uint32_t> parent_;
};

} // namespace palpate
