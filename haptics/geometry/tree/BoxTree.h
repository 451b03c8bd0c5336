// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "haptics/core/Types.h"

namespace palpate
{

/// The boxes of both children of an inner node, coordinate by coordinate so that both are tested at once.
struct alignas(16) NodeBoxes
{
  std::array<std::array<double, 2>, 3> low_W; ///< [axis][child]
  std::array<std::array<double, 2>, 3> high_W;
};

/// An inner node. A child index with leafBit set names a leaf.
struct TreeNode : NodeBoxes
{
  static constexpr std::uint32_t leafBit = 0x80000000u;
  std::array<std::uint32_t, 2> child;
};

struct Box
{
  Vec3 low_W = Vec3::Zero();
  Vec3 high_W = Vec3::Zero();

  void include(const Vec3& p_W) noexcept
  {
    this->low_W = this->low_W.cwiseMin(p_W);
    this->high_W = this->high_W.cwiseMax(p_W);
  }
};

/// A tree of boxes, one leaf a box, over a few things that are trees themselves: the surfaces of a scene.
struct BoxTree
{
  std::vector<TreeNode> nodes; ///< empty when there is a single leaf
  Box bounds;

  /// Where a walk begins.
  [[nodiscard]] std::uint32_t root() const noexcept { return this->nodes.empty() ? TreeNode::leafBit : 0u; }
};

/// Halved at the middle box along the longest side of the centres; ties by index. Leaf i is box i. O(n log^2 n).
[[nodiscard]] BoxTree makeBoxTree(const std::vector<Box>& boxes);

} // namespace palpate
