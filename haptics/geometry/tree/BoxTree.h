// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
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

  /// A box around no point.
  [[nodiscard]] static Box empty() noexcept
  {
    constexpr double inf = std::numeric_limits<double>::infinity();
    return { Vec3::Constant(inf), Vec3::Constant(-inf) };
  }
  void include(const Vec3& p_W) noexcept
  {
    this->low_W = this->low_W.cwiseMin(p_W);
    this->high_W = this->high_W.cwiseMax(p_W);
  }
  void include(const Box& other) noexcept
  {
    this->low_W = this->low_W.cwiseMin(other.low_W);
    this->high_W = this->high_W.cwiseMax(other.high_W);
  }
};

[[nodiscard]] inline Box boxOf(const NodeBoxes& node, std::size_t child) noexcept
{
  return { Vec3(node.low_W[0][child], node.low_W[1][child], node.low_W[2][child]),
    Vec3(node.high_W[0][child], node.high_W[1][child], node.high_W[2][child]) };
}

inline void setBox(NodeBoxes& node, std::size_t child, const Box& box) noexcept
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    node.low_W[axis][child] = box.low_W[static_cast<Eigen::Index>(axis)];
    node.high_W[axis][child] = box.high_W[static_cast<Eigen::Index>(axis)];
  }
}

/// The box around the corners of a triangle.
[[nodiscard]] inline Box boxOf(const std::array<Vec3, 3>& corners_W) noexcept
{
  return { corners_W[0].cwiseMin(corners_W[1]).cwiseMin(corners_W[2]),
    corners_W[0].cwiseMax(corners_W[1]).cwiseMax(corners_W[2]) };
}

[[nodiscard]] inline bool overlap(const Box& a, const Box& b) noexcept
{
  return (a.low_W.array() <= b.high_W.array()).all() && (b.low_W.array() <= a.high_W.array()).all();
}

/// A tree of boxes, with one leaf per box, over a few objects that are trees themselves: the surfaces of a scene.
struct BoxTree
{
  std::vector<TreeNode> nodes; ///< empty when there is a single leaf
  Box bounds;

  /// The child index at which a traversal begins.
  [[nodiscard]] std::uint32_t root() const noexcept { return this->nodes.empty() ? TreeNode::leafBit : 0u; }
};

/// Split by splitAtMedian() of the centres. Leaf i is box i. O(n log n).
[[nodiscard]] BoxTree makeBoxTree(const std::vector<Box>& boxes);

} // namespace palpate
