// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace palpate
{

/// Work that may still be done: a budget in time would give other poses on every machine. The unit is the cost of a
/// pair of boxes that is visited, about 50 ns on a core of 2020; see work_price.
class WorkBudget
{
public:
  explicit WorkBudget(std::uint64_t units) noexcept : left_(units) {}

  /// False once nothing is left.
  [[nodiscard]] bool spend(std::uint64_t units = 1) noexcept
  {
    const bool enough = this->left_ >= units;
    this->left_ = enough ? this->left_ - units : 0;
    return enough;
  }
  /// For work that is done in any case: the part that there is not enough for is owed.
  void charge(std::uint64_t units) noexcept
  {
    const std::uint64_t paid = std::min(units, this->left_);
    this->left_ -= paid;
    this->owed_ += units - paid;
  }
  [[nodiscard]] std::uint64_t left() const noexcept { return this->left_; }
  [[nodiscard]] std::uint64_t owed() const noexcept { return this->owed_; }

private:
  std::uint64_t left_, owed_ = 0;
};

/// Measured costs of other operations, in units.
namespace work_price
{
constexpr std::uint64_t span = 8;        ///< a test of a part of a step of two triangles
constexpr std::uint64_t leafPlane = 8;   ///< the search for a plane between two leaves
constexpr std::uint64_t plan = 16;       ///< planning a step; and
constexpr std::uint64_t planOfRow = 4;   ///< for each of its rows
constexpr std::size_t looksPerUnit = 8;  ///< comparisons of a pair's key
constexpr std::size_t planesPerUnit = 3; ///< evaluations of a plane between boxes
constexpr std::uint64_t gap = 1;         ///< the gap along a known plane
constexpr std::uint64_t touching = 2;    ///< the search for features of two triangles that touch
} // namespace work_price

} // namespace palpate
