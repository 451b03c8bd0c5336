// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "haptics/geometry/tree/BoxTree.h"
#include "haptics/geometry/tree/SurfaceData.h"

namespace palpate
{

/// A tree over 2^32 leaves that halves exactly is 32 deep, and a traversal keeps at most one sibling per level. A
/// factor of 3 allows for trees that do not halve exactly.
inline constexpr int mostPending = 96;

/// Visits the leaves that matter, nearest first. Nodes: std::vector<TreeNode>, or a type with the same [] and
/// empty(). `entriesOf(node)`: distances of both children; a child is kept where `reaches(distance)`, and visited
/// later where `admits(distance)`, which may count the visits. `onLeaf(index)`.
template<class Nodes, class EntriesOf, class Reaches, class Admits, class OnLeaf>
void walkNearestFirst(const Nodes& nodes, double rootEntry, const EntriesOf& entriesOf, const Reaches& reaches,
  const Admits& admits, const OnLeaf& onLeaf) noexcept
{
  struct Pending
  {
    std::uint32_t child;
    double entry;
  };
  std::array<Pending, mostPending> stack;
  int top = 0;
  if (reaches(rootEntry))
  {
    stack[top++] = { nodes.empty() ? TreeNode::leafBit : 0u, rootEntry };
  }
  while (top > 0)
  {
    const Pending next = stack[--top];
    if (!admits(next.entry))
    {
      continue;
    }
    if (next.child & TreeNode::leafBit)
    {
      onLeaf(next.child & ~TreeNode::leafBit);
      continue;
    }
    const TreeNode& node = nodes[next.child];
    const std::array<double, 2> entries = entriesOf(node);
    const int far = entries[0] <= entries[1] ? 1 : 0;
    for (const int k : { far, 1 - far })
    {
      if (reaches(entries[k]))
      {
        stack[top++] = { node.child[k], entries[k] };
      }
    }
  }
}

/// Visits each leaf above which every box meets, in no particular order. `meets(node)`: a bool for each child; the
/// traversal ends with false where `goesOn()`, called once for each node and leaf, or `onLeaf(index)` returns false.
template<class Nodes, class GoesOn, class Meets, class OnLeaf>
[[nodiscard]] bool walkMeeting(const Nodes& nodes, const GoesOn& goesOn, const Meets& meets, const OnLeaf& onLeaf)
{
  std::array<std::uint32_t, mostPending> stack;
  int top = 0;
  stack[top++] = nodes.empty() ? TreeNode::leafBit : 0u;
  while (top > 0)
  {
    const std::uint32_t child = stack[--top];
    if (!goesOn())
    {
      return false;
    }
    if (child & TreeNode::leafBit)
    {
      if (!onLeaf(child & ~TreeNode::leafBit))
      {
        return false;
      }
      continue;
    }
    const TreeNode& node = nodes[child];
    const std::array<bool, 2> met = meets(node);
    for (std::size_t k = 0; k < 2; ++k)
    {
      if (met[k])
      {
        stack[top++] = node.child[k];
      }
    }
  }
  return true;
}

/// Calls visit(triangle) for each triangle of the leaves above which every box meets: `meets(box)`.
template<class Meets, class Visit>
void forEachMeeting(const SurfaceData& surface, const Meets& meets, const Visit& visit)
{
  const auto both = [&meets](const TreeNode& node) {
    return std::array<bool, 2>{ meets(boxOf(node, 0)), meets(boxOf(node, 1)) };
  };
  const auto visitLeaf = [&](std::uint32_t index)
  {
    surface.forEachInLeaf(index, visit);
    return true;
  };
  static_cast<void>(walkMeeting(
    surface.nodes, [] { return true; }, both, visitLeaf));
}

} // namespace palpate
