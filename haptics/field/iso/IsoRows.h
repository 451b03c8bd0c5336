// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "haptics/contact/planes/Projection.h"
#include "haptics/field/iso/IsoSpace.h"

namespace palpate
{

/// The planes that hold a proxy.
struct IsoRows
{
  std::array<IsoRow, IsoState::mostCells> row;
  int count = 0;

  [[nodiscard]] std::span<const IsoRow> all() const noexcept
  {
    return { this->row.data(), static_cast<std::size_t>(this->count) };
  }
  void forget(int first) noexcept;
};

/// Where the proxy is, where the hand is seen from there, and which of them is new.
struct IsoView
{
  const IsoSpace& space;
  const IsoSide& of;
  const GridPlace& x;
  Vec3 q_u;               ///< from the proxy to the hand
  bool newestHit = false; ///< the newest cell was met just now: it is kept whatever its polynomial says
};

/// How far a plane may be violated by rounding [u].
[[nodiscard]] inline double slackOf(const IsoView& view) noexcept
{
  return 1e-15 * (view.q_u.norm() + view.space.rounded_u(view.x));
}

/// The planes of the cells at x. One is dropped where x is legal and the extended polynomial denies it, which is a
/// ridge, where its patch is half a cell away, or its cell is.
[[nodiscard]] IsoRows rowsAt(const IsoView& view, std::span<const GridIndex> cells) noexcept;

/// The step nearest to `target_u` that each plane allows once it is raised by `lift_u`. Contradicting planes: the
/// newest two, then the newest, which are then those of `rows`.
[[nodiscard]] ProjectionResult projectOntoRows(
  IsoRows& rows, const Vec3& target_u, std::span<const double> lift_u, double slack_u) noexcept;

} // namespace palpate
