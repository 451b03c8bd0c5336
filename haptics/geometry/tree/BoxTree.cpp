// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/tree/BoxTree.h"

#include <numeric>
#include <span>

#include "haptics/geometry/tree/MedianSplit.h"

namespace palpate
{
namespace
{

class Builder
{
public:
  Builder(const std::vector<Box>& boxes, std::vector<TreeNode>& nodes) : boxes_(boxes), nodes_(nodes) {}

  /// Adds the tree over these boxes, sets `around` to their bounds, and returns the index of the root, with leafBit for
  /// a single box.
  std::uint32_t build(std::span<std::uint32_t> some, Box& around)
  {
    if (some.size() == 1)
    {
      around = this->boxes_[some[0]];
      return some[0] | TreeNode::leafBit;
    }
    const std::size_t half =
      splitAtMedian(some, [this](std::uint32_t i) { return Vec3(this->boxes_[i].low_W + this->boxes_[i].high_W); });
    const std::size_t at = this->nodes_.size();
    this->nodes_.emplace_back();
    around = Box::empty();
    for (const std::size_t k : { 0U, 1U })
    {
      Box inside;
      const std::uint32_t child = this->build(k == 0 ? some.first(half) : some.subspan(half), inside);
      setBox(this->nodes_[at], k, inside);
      this->nodes_[at].child[k] = child;
      around.include(inside);
    }
    return static_cast<std::uint32_t>(at);
  }

private:
  const std::vector<Box>& boxes_;
  std::vector<TreeNode>& nodes_;
};

} // namespace

BoxTree makeBoxTree(const std::vector<Box>& boxes)
{
  BoxTree tree;
  if (!boxes.empty())
  {
    std::vector<std::uint32_t> all(boxes.size());
    std::iota(all.begin(), all.end(), 0u);
    Builder(boxes, tree.nodes).build(all, tree.bounds);
  }
  return tree;
}

} // namespace palpate
