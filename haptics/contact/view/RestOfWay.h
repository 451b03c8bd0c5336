// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "haptics/contact/view/BentSurface.h"
#include "haptics/geometry/tree/SurfaceData.h"

namespace palpate
{

/// A surface that bends, from one moment of its way to the end, in its own frame: all that holds it at both holds it at
/// any moment between, as each coordinate of a vertex goes evenly from one to the other.
class RestOfWay
{
public:
  explicit RestOfWay(const BentSurface& now) noexcept : now_(now) {}

  [[nodiscard]] const BentSurface& now() const noexcept { return this->now_; }
  [[nodiscard]] const SurfaceData& data() const noexcept { return this->now_.data(); }
  /// Corners of a triangle now, and at the end.
  [[nodiscard]] std::array<std::array<Vec3, 3>, 2> cornersOf(std::uint32_t triangle) const noexcept;

private:
  const BentSurface& now_;
};

/// The tree of that: each box is around the boxes of both.
class RestNodes
{
public:
  explicit RestNodes(const RestOfWay& rest) noexcept : now_(rest.now()), end_(rest.data().nodes) {}
  [[nodiscard]] bool empty() const noexcept { return this->end_.empty(); }
  [[nodiscard]] TreeNode operator[](std::uint32_t index) const noexcept;

private:
  BentNodes now_;
  const std::vector<TreeNode>& end_;
};

[[nodiscard]] inline RestNodes nodesOf(const RestOfWay& rest) noexcept
{
  return RestNodes(rest);
}
/// Balls around four faces on all of that way: discs without a normal.
[[nodiscard]] DiscQuad discsOf(const RestOfWay& rest, std::size_t quad) noexcept;

} // namespace palpate
