// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "haptics/core/Types.h"
#include "haptics/field/cells/TrilinearCell.h"

namespace palpate
{

/// Where the places of a cell with eight corners are: trilinear between the corners, in the order of TrilinearCell.
/// Wedges, pyramids and tetrahedra are such cells with corners that coincide, and are filled as their own shape
/// functions fill them: on a face of which two corners are one, a function that is linear is so still.
class CellMap
{
public:
  explicit CellMap(const std::array<Vec3, 8>& corners_W) noexcept;

  [[nodiscard]] Vec3 at(const Vec3& t) const noexcept;
  /// Column k: how the place changes with t[k]. Of a cell with corners that coincide it is taken just beside them.
  [[nodiscard]] Mat3 jacobian(const Vec3& t) const noexcept;
  /// Where a jacobian and a gradient are taken for a place.
  [[nodiscard]] Vec3 regular(const Vec3& t) const noexcept;
  /// The local place of a place in W by Newton's steps, bounded; none where they do not end.
  [[nodiscard]] std::optional<Vec3> find(const Vec3& p_W, const Vec3& start) const noexcept;
  /// Length of the longest diagonal [u].
  [[nodiscard]] double size_u() const noexcept { return this->size_u_; }
  [[nodiscard]] const std::array<Vec3, 8>& corners_W() const noexcept { return this->corner_W_; }

private:
  std::array<Vec3, 8> corner_W_;
  double size_u_ = 0.0;
  bool collapsed_ = false;
};

/// Whether a local place is in its cell, but for rounding.
[[nodiscard]] inline bool isInCell(const Vec3& t, double rounding) noexcept
{
  return (t.array() >= -rounding).all() && (t.array() <= 1.0 + rounding).all();
}

} // namespace palpate
