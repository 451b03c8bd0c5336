// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "haptics/core/Progress.h"
#include "haptics/core/Types.h"

namespace palpate
{

/// A drawing: which pixels have ink, row after row. Its edge counts as blank all round.
struct Bitmap
{
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> ink; ///< width * height, 0 or 1

  [[nodiscard]] bool at(std::int64_t x, std::int64_t y) const noexcept
  {
    return x >= 0 && y >= 0 && x < this->width && y < this->height &&
           this->ink[static_cast<std::size_t>(y * this->width + x)] != 0;
  }
};

/// The eight pixels round one, from above it clockwise.
inline constexpr std::array<std::array<int, 2>, 8> pixelsRound{ { { 0, -1 }, { 1, -1 }, { 1, 0 }, { 1, 1 }, { 0, 1 },
  { -1, 1 }, { -1, 0 }, { -1, -1 } } };

/// Takes ink from the sides of strokes, evenly, until they are one pixel wide: Guo & Hall 1989. Pieces stay as many as
/// they are and keep their holes; ends of strokes stay. Half done where goes says no. O(pixels).
void thin(Bitmap& drawing, const Goes& goes = always);

/// Loose lines: points and pairs of their indices.
struct LooseLines
{
  std::vector<Vec3> points_W;
  std::vector<std::array<std::uint32_t, 2>> segments;
};

/// The lines from pixel to neighbouring pixel of a thinned drawing, a point at each pixel (x, y, 0) with ink. Across a
/// corner only where no third pixel joins the two: so a bend has no little triangle.
[[nodiscard]] LooseLines linesOf(const Bitmap& thinned);

/// Mends the lines of a thinned drawing (in pixels), given the drawing as it was before it was thinned and how long its
/// pixels are [u]. First it leaves out the hooks: lines shorter than gap_u > 0 between a free end and a place where
/// more than two meet, which thinning leaves behind and which would be closed to loops. Then it joins every free end to
/// the line across the least blank, where that is no wider than gap_u: measured from the tip of the stroke to the rim
/// of the other, so strokes of any width count alike. A place to which the lines themselves lead by less than twice the
/// straight distance is none to join. Half done where goes says no. O(pixels) for evenly spread ends.
void mendGaps(
  LooseLines& lines, const Bitmap& drawing, const Eigen::Vector2d& pixel_u, double gap_u, const Goes& goes = always);

} // namespace palpate
