// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "haptics/contact/planes/Projection.h"
#include "haptics/field/iso/IsoProxy.h"
#include "haptics/field/iso/LevelSet.h"

namespace palpate
{

/// The polynomial of one cell, seen from the proxy: its plane there and how it bends. Lengths [u] in the grid's axes.
struct IsoRow
{
  GridIndex cell{};
  Vec3 n = Vec3::UnitX();
  double gap_u = 0.0;       ///< to the patch's plane, along n
  double margin_u = 0.0;    ///< that a landing keeps
  Vec3 bend = Vec3::Zero(); ///< second derivatives over |gradient|: by y and z, z and x, x and y [1/u]

  [[nodiscard]] double bending(const Vec3& a, const Vec3& b) const noexcept
  {
    return this->bend.x() * (a.y() * b.z() + a.z() * b.y()) + this->bend.y() * (a.z() * b.x() + a.x() * b.z()) +
           this->bend.z() * (a.x() * b.y() + a.y() * b.x());
  }
};

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
  const LevelSet& set;
  const Vec3& spacing_u;
  const GridPlace& x;
  Vec3 q_u;               ///< from the proxy to the hand
  bool newestHit = false; ///< the newest cell was met just now: it is kept whatever its polynomial says
};

/// How far a plane may be violated by rounding [u].
[[nodiscard]] inline double slackOf(const IsoView& view) noexcept
{
  return 1e-15 * (view.q_u.norm() + view.spacing_u.minCoeff());
}

/// The planes of the cells at x. One is dropped where x is legal and the extended polynomial denies it, which is a
/// ridge, where its patch is half a cell away, or its cell is.
[[nodiscard]] IsoRows rowsAt(const IsoView& view, std::span<const GridIndex> cells) noexcept;

/// The step nearest to `target_u` that each plane allows once it is raised by `lift_u`. Contradicting planes: the
/// newest two, then the newest, which are then those of `rows`.
[[nodiscard]] ProjectionResult projectOntoRows(
  IsoRows& rows, const Vec3& target_u, std::span<const double> lift_u, double slack_u) noexcept;

} // namespace palpate
