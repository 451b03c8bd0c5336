// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace palpate::test
{

/// Costs of a tick, in walks of the plain tree at their median.
struct TickCosts
{
  double p50, p99, most;
};

/// The least that was seen of a row.
struct TickRow
{
  std::string_view name;
  bool million; ///< of a million triangles; else of a hundred thousand
  TickCosts best;
};

/// The best of three measurements on two idle cores, of whole ticks and of bending beside other work
/// (docs/performance.md names the machine). A row may cost a tenth
/// more before palpate-tick-bench calls it OVER; the test allows more, as it runs on any machine.
inline constexpr std::array tickRows = std::to_array<TickRow>({
  { "point", false, { 3.2, 28.6, 128.9 } },
  { "ball", false, { 4.0, 83.8, 269.8 } },
  { "ball, friction", false, { 3.7, 73.4, 461.0 } },
  { "ball, shading", false, { 30.8, 110.3, 229.9 } },
  { "point, noise", false, { 3.7, 40.4, 108.0 } },
  { "ball, noise", false, { 4.4, 109.6, 332.9 } },
  { "ball, whole tick", false, { 5.9, 84.0, 186.0 } },
  { "ball, bending", false, { 22.9, 157.2, 321.1 } },
  { "point", true, { 4.4, 21.3, 140.7 } },
  { "ball", true, { 9.0, 82.8, 422.9 } },
  { "ball, friction", true, { 7.8, 107.2, 683.4 } },
  { "ball, shading", true, { 37.9, 207.7, 308.1 } },
  { "point, noise", true, { 21.1, 74.8, 390.4 } },
  { "ball, noise", true, { 1.9, 529.3, 1112.9 } },
});

/// The best costs of a row; null where none are known.
[[nodiscard]] inline const TickCosts* bestOf(std::string_view name, std::size_t triangles) noexcept
{
  const bool million = triangles > 500000;
  const auto found =
    std::ranges::find_if(tickRows, [&](const TickRow& row) { return row.name == name && row.million == million; });
  return found == tickRows.end() ? nullptr : &found->best;
}

} // namespace palpate::test
