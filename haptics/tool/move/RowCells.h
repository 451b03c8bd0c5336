// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "haptics/core/Types.h"

namespace palpate
{

/// Numbers of rows by the position of their points, in cells of a hashed grid (Teschner et al. 2003): a fit that
/// touches all around has a thousand rows, and each must be compared with all others.
class RowCells
{
public:
  explicit RowCells(double cell_u) : cell_u_(cell_u) { this->clear(); }

  void clear()
  {
    this->heads_.fill(none);
    this->next_.clear();
  }
  /// Adds a row, whose number is the count so far.
  void add(const Vec3& p)
  {
    std::uint32_t& head = this->heads_[slotOf(this->cellOf(p))];
    this->next_.push_back(head);
    head = static_cast<std::uint32_t>(this->next_.size() - 1);
  }
  /// True if the question is true for a row whose point may lie within that distance.
  template<class Question>
  [[nodiscard]] bool any(const Vec3& p, double within_u, Question question) const
  {
    const Cell low = this->cellOf(p - Vec3::Constant(within_u)), high = this->cellOf(p + Vec3::Constant(within_u));
    Cell cell = low;
    for (cell[0] = low[0]; cell[0] <= high[0]; ++cell[0])
    {
      for (cell[1] = low[1]; cell[1] <= high[1]; ++cell[1])
      {
        for (cell[2] = low[2]; cell[2] <= high[2]; ++cell[2])
        {
          if (this->anyIn(slotOf(cell), question))
          {
            return true;
          }
        }
      }
    }
    return false;
  }

private:
  static constexpr std::uint32_t none = ~std::uint32_t{ 0 };
  static constexpr std::size_t slots = 1024;
  using Cell = std::array<std::int64_t, 3>;

  [[nodiscard]] Cell cellOf(const Vec3& p) const
  {
    Cell cell;
    for (int k = 0; k < 3; ++k)
    {
      cell[k] = static_cast<std::int64_t>(std::floor(p[k] / this->cell_u_));
    }
    return cell;
  }
  [[nodiscard]] static std::size_t slotOf(const Cell& cell)
  {
    const auto hash = static_cast<std::uint64_t>(cell[0]) * 73856093u ^
                      static_cast<std::uint64_t>(cell[1]) * 19349663u ^ static_cast<std::uint64_t>(cell[2]) * 83492791u;
    return hash % slots;
  }
  template<class Question>
  [[nodiscard]] bool anyIn(std::size_t slot, Question question) const
  {
    for (std::uint32_t row = this->heads_[slot]; row != none; row = this->next_[row])
    {
      if (question(row))
      {
        return true;
      }
    }
    return false;
  }

  double cell_u_;
  std::array<std::uint32_t, slots> heads_;
  std::vector<std::uint32_t> next_; ///< by row: the one before it in the same slot
};

} // namespace palpate
