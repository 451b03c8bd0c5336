// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "haptics/field/iso/LevelSet.h"

namespace palpate
{

enum class SweepEnd : std::uint8_t
{
  Reached, ///< the whole displacement is free
  Hit,     ///< the surface is in the way
  Left     ///< the grid ends, or a corner has no value
};

struct FieldSweepResult
{
  GridPlace place; ///< where the sweep ended, on the same side as it began
  SweepEnd end = SweepEnd::Reached;
  GridIndex met{};         ///< the cell in which the surface is, if it is in the way
  std::uint32_t cells = 0; ///< that were looked into
};

/// The straight sweep from a place on the side of a level set to the first place that is not: cell by cell, in each the
/// first root of a cubic, so that no sheet is too thin. `way`: in cells. Bounded by the cells of the sweep in the grid.
[[nodiscard]] FieldSweepResult sweepField(const LevelSet& set, const GridPlace& from, const Vec3& way) noexcept;

} // namespace palpate
