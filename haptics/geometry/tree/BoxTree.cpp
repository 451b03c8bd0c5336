// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/tree/BoxTree.h"

#include <algorithm>
#include <numeric>
#include <span>

namespace palpate
{
namespace
{

class Builder
{
public:
  Builder(const std::vector<Box>& boxes, std::vector<TreeNode>& nodes) : boxes_(boxes), nodes_(nodes) {}

  /// Adds the tree over these boxes and returns the index of its root, with leafBit for a single one.
  std::uint32_t build(std::span<std::uint32_t> some)
  {
    if (some.size() == 1)
    {
      return some[0] | TreeNode::leafBit;
    }
    this->sortAlongLongest(some);
    const auto at = static_cast<std::uint32_t>(this->nodes_.size());
    this->nodes_.emplace_back();
    const std::array<std::span<std::uint32_t>, 2> halves{ some.first(some.size() / 2), some.subspan(some.size() / 2) };
    for (std::size_t k = 0; k < 2; ++k)
    {
      const Box around = this->around(halves[k]);
      const std::uint32_t child = this->build(halves[k]);
      TreeNode& node = this->nodes_[at];
      for (int axis = 0; axis < 3; ++axis)
      {
        node.low_W[static_cast<std::size_t>(axis)][k] = around.low_W[axis];
        node.high_W[static_cast<std::size_t>(axis)][k] = around.high_W[axis];
      }
      node.child[k] = child;
    }
    return at;
  }

  [[nodiscard]] Box around(std::span<const std::uint32_t> some) const
  {
    Box all = this->boxes_[some[0]];
    for (const std::uint32_t i : some)
    {
      all.low_W = all.low_W.cwiseMin(this->boxes_[i].low_W);
      all.high_W = all.high_W.cwiseMax(this->boxes_[i].high_W);
    }
    return all;
  }

private:
  [[nodiscard]] Vec3 centre(std::uint32_t i) const { return 0.5 * (this->boxes_[i].low_W + this->boxes_[i].high_W); }

  void sortAlongLongest(std::span<std::uint32_t> some) const
  {
    Vec3 low = this->centre(some[0]), high = low;
    for (const std::uint32_t i : some)
    {
      low = low.cwiseMin(this->centre(i));
      high = high.cwiseMax(this->centre(i));
    }
    int axis = 0;
    (high - low).maxCoeff(&axis);
    std::sort(some.begin(), some.end(),
      [this, axis](std::uint32_t a, std::uint32_t b)
      {
        const double along = this->centre(a)[axis], other = this->centre(b)[axis];
        return along != other ? along < other : a < b;
      });
  }

  const std::vector<Box>& boxes_;
  std::vector<TreeNode>& nodes_;
};

} // namespace

BoxTree makeBoxTree(const std::vector<Box>& boxes)
{
  BoxTree tree;
  if (boxes.empty())
  {
    return tree;
  }
  std::vector<std::uint32_t> all(boxes.size());
  std::iota(all.begin(), all.end(), 0u);
  Builder builder(boxes, tree.nodes);
  tree.bounds = builder.around(all);
  builder.build(all);
  return tree;
}

} // namespace palpate
