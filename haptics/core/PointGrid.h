// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "haptics/core/Types.h"

namespace palpate
{

/// A box cut along its axes into cells of one size, x fastest. A point outside belongs to the nearest cell.
struct PointGrid
{
  using Cell = std::array<int, 3>;

  Vec3 low = Vec3::Zero();
  Vec3 edge = Vec3::Ones(); ///< of a cell
  Cell size{ 1, 1, 1 };     ///< cells along each axis

  [[nodiscard]] std::size_t count() const noexcept
  {
    return static_cast<std::size_t>(this->size[0]) * this->size[1] * this->size[2];
  }
  [[nodiscard]] Cell cellOf(const Vec3& p) const noexcept
  {
    Cell cell{};
    for (int k = 0; k < 3; ++k)
    {
      const double at = (p[k] - this->low[k]) / this->edge[k];
      cell[k] = static_cast<int>(std::fmin(std::fmax(at, 0.0), this->size[k] - 1.0));
    }
    return cell;
  }
  [[nodiscard]] std::size_t indexOf(const Cell& cell) const noexcept
  {
    return cell[0] + this->size[0] * (cell[1] + this->size[1] * static_cast<std::size_t>(cell[2]));
  }
  /// Calls visit(index) for each cell from `first` to `last`, both among them.
  template<class Visit>
  void forEach(const Cell& first, const Cell& last, const Visit& visit) const
  {
    for (int z = first[2]; z <= last[2]; ++z)
    {
      for (int y = first[1]; y <= last[1]; ++y)
      {
        for (int x = first[0]; x <= last[0]; ++x)
        {
          visit(this->indexOf({ x, y, z }));
        }
      }
    }
  }
};

} // namespace palpate
