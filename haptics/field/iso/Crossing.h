// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "haptics/field/cells/TrilinearCell.h"

namespace palpate
{

/// A trilinear function along a straight line is a cubic; its four Bernstein coefficients are taken by blossoming, so
/// nothing is expanded and nothing cancels.
struct WayCubic
{
  WayCubic(const TrilinearCell& cell, const Vec3& from, const Vec3& to) noexcept;

  std::array<double, 4> b; ///< b[0] and b[3]: the values at both ends

  /// No coefficient is negative: neither is any value on the segment.
  [[nodiscard]] bool free() const noexcept
  {
    return this->b[0] >= 0.0 && this->b[1] >= 0.0 && this->b[2] >= 0.0 && this->b[3] >= 0.0;
  }
  [[nodiscard]] double at(double u) const noexcept;
  /// Where the first negative value of a segment that begins at none comes, 0 to 1, to rounding; none where there is
  /// none.
  [[nodiscard]] std::optional<double> firstCrossing() const noexcept;
};

} // namespace palpate
