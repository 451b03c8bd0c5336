// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "haptics/contact/sweep/BoxTest.h"
#include "haptics/contact/view/SweepQuery.h"
#include "haptics/geometry/tree/TreeWalk.h"

namespace palpate
{

/// Calls onLeaf(index) for the leaves that the way up to the best hit can touch, nearest first. Where the budget of
/// visited nodes is met, best.freeUntil says up to where the way is proven free.
/// Nodes: std::vector<TreeNode>, or BentNodes.
template<class Nodes, class OnLeaf>
void walkNearFirst(const Nodes& nodes, const Box& bounds, const SweptBall& m, std::uint32_t budget, SweepHit& best,
  OnLeaf onLeaf) noexcept
{
  BoxTest test(m);
  test.shortenTo(best.t);
  const auto reaches = [&best](double entry) noexcept { return entry <= best.t; };
  const auto admits = [&best, budget](double entry) noexcept
  {
    if (entry > best.t)
    {
      return false;
    }
    if (best.work >= budget)
    {
      best.freeUntil = std::min(best.freeUntil, entry);
      return false;
    }
    ++best.work;
    return true;
  };
  const auto shorten = [&](std::uint32_t leaf) noexcept
  {
    const double before = best.t;
    onLeaf(leaf);
    if (best.t < before)
    {
      test.shortenTo(best.t);
    }
  };
  const auto entriesOf = [&test](const TreeNode& node) noexcept { return test(node).time; };
  walkNearestFirst(nodes, test.one(bounds.low_W, bounds.high_W), entriesOf, reaches, admits, shorten);
}

/// Calls onLeaf(index) for every leaf whose box the motion can touch, in no particular order, until it returns false.
/// `nodes` counts the nodes and leaves that were visited; at the budget, or where onLeaf says so, the walk ends and the
/// result is false.
template<class Nodes, class OnLeaf>
[[nodiscard]] bool walkWithin(
  const Nodes& tree, const BoxTest& test, std::uint32_t budget, std::uint32_t& nodes, OnLeaf onLeaf) noexcept
{
  const auto meets = [&test](const TreeNode& node) noexcept
  {
    const Entries entries = test(node);
    return std::array<bool, 2>{ entries.time[0] <= 1.0, entries.time[1] <= 1.0 };
  };
  return walkMeeting(
    tree, [&nodes, budget]() noexcept { return ++nodes < budget; }, meets, onLeaf);
}

} // namespace palpate
