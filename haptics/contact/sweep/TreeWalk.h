// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "haptics/contact/sweep/BoxTest.h"
#include "haptics/contact/view/SweepQuery.h"
#include "haptics/geometry/tree/BoxTree.h"

namespace palpate
{

/// A halving tree over 2^32 leaves is 32 deep, and a walk keeps at most one sibling a level. Three times as much leaves
/// room for trees that do not halve exactly.
inline constexpr int mostPending = 96;

/// Calls onLeaf(index) for the leaves that the way up to the best hit can touch, nearest first. Where the budget of
/// visited nodes is met, best.freeUntil says up to where the way is proven free.
/// Nodes: std::vector<TreeNode>, or BentNodes.
template<class Nodes, class OnLeaf>
void walkNearFirst(const Nodes& nodes, const Box& bounds, const SweptBall& m, std::uint32_t budget, SweepHit& best,
  OnLeaf onLeaf) noexcept
{
  struct Pending
  {
    std::uint32_t child;
    double entry;
  };
  std::array<Pending, mostPending> stack;
  int top = 0;
  BoxTest test(m);
  test.shortenTo(best.t);
  const double rootEntry = test.one(bounds.low_W, bounds.high_W);
  if (rootEntry <= best.t)
  {
    stack[top++] = { nodes.empty() ? TreeNode::leafBit : 0u, rootEntry };
  }
  while (top > 0)
  {
    const Pending next = stack[--top];
    if (next.entry > best.t)
    {
      continue;
    }
    if (best.work >= budget)
    {
      best.freeUntil = std::min(best.freeUntil, next.entry);
      continue;
    }
    ++best.work;
    if (next.child & TreeNode::leafBit)
    {
      const double before = best.t;
      onLeaf(next.child & ~TreeNode::leafBit);
      if (best.t < before)
      {
        test.shortenTo(best.t);
      }
      continue;
    }
    const TreeNode& node = nodes[next.child];
    const Entries entries = test(node);
    const int far = entries.time[0] <= entries.time[1] ? 1 : 0;
    for (const int k : { far, 1 - far })
    {
      if (entries.time[k] <= best.t)
      {
        stack[top++] = { node.child[k], entries.time[k] };
      }
    }
  }
}

/// Calls onLeaf(index) for every leaf whose box the motion can touch, in no particular order, until it returns false.
/// `nodes` counts what was visited; at the budget, or where onLeaf says so, the walk ends and the result is false.
template<class Nodes, class OnLeaf>
[[nodiscard]] bool walkWithin(
  const Nodes& tree, const BoxTest& test, std::uint32_t budget, std::uint32_t& nodes, OnLeaf onLeaf) noexcept
{
  std::array<std::uint32_t, mostPending> stack;
  int top = 0;
  stack[top++] = tree.empty() ? TreeNode::leafBit : 0u;
  while (top > 0)
  {
    const std::uint32_t child = stack[--top];
    if (++nodes >= budget)
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
    const TreeNode& node = tree[child];
    const Entries entries = test(node);
    for (int k = 0; k < 2; ++k)
    {
      if (entries.time[k] <= 1.0)
      {
        stack[top++] = node.child[k];
      }
    }
  }
  return true;
}

} // namespace palpate
