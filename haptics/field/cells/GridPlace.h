// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

#include "haptics/core/Types.h"

namespace palpate
{

using GridIndex = std::array<int, 3>; ///< of a point, or of the cell whose lowest corner it is

/// A place in a uniform grid: a cell and where in it, 0 to 1 along each axis. So the resolution does not depend on the
/// size of the grid. A place on a face may be named by either cell.
struct GridPlace
{
  GridIndex cell{};
  Vec3 t = Vec3::Zero();

  /// Places further out than an int are none of any grid: they are cut.
  [[nodiscard]] static GridPlace at(const Vec3& index) noexcept
  {
    constexpr double furthest = 1e9;
    GridPlace place;
    for (int k = 0; k < 3; ++k)
    {
      const double at = std::fmin(std::fmax(index[k], -furthest), furthest);
      const int whole = static_cast<int>(at);
      place.cell[k] = whole - (at < whole ? 1 : 0);
      place.t[k] = at - place.cell[k];
    }
    return place;
  }

  [[nodiscard]] Vec3 index() const noexcept
  {
    return { this->cell[0] + this->t.x(), this->cell[1] + this->t.y(), this->cell[2] + this->t.z() };
  }

  /// This place as seen from a cell.
  [[nodiscard]] Vec3 in(const GridIndex& other) const noexcept
  {
    return { (this->cell[0] - other[0]) + this->t.x(), (this->cell[1] - other[1]) + this->t.y(),
      (this->cell[2] - other[2]) + this->t.z() };
  }

  /// From another place to this one, in cells.
  [[nodiscard]] Vec3 from(const GridPlace& other) const noexcept
  {
    return { (this->cell[0] - other.cell[0]) + (this->t.x() - other.t.x()),
      (this->cell[1] - other.cell[1]) + (this->t.y() - other.t.y()),
      (this->cell[2] - other.cell[2]) + (this->t.z() - other.t.z()) };
  }
};

} // namespace palpate
