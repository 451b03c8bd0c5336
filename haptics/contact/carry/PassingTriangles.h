// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "haptics/contact/sweep/NearFilter.h"
#include "haptics/contact/sweep/Neighbourhood.h"
#include "haptics/contact/sweep/TreeWalk.h"
#include "haptics/contact/view/SceneView.h"
#include "haptics/core/Types.h"
#include "haptics/geometry/mesh/NearestOnTriangle.h"
#include "haptics/geometry/tree/BoxTree.h"
#include "haptics/geometry/tree/SurfaceData.h"

namespace palpate
{

/// Corners in the surface's own frame.
[[nodiscard]] inline std::array<Vec3, 3> ownCorners(const SurfaceData& s, std::uint32_t triangle) noexcept
{
  return s.cornersOf(triangle);
}

[[nodiscard]] inline std::array<Vec3, 3> ownCorners(const PosedSurface& s, std::uint32_t triangle) noexcept
{
  return s.shape().cornersOf(triangle);
}

/// The tree of a surface at the moment of the view.
[[nodiscard]] inline const std::vector<TreeNode>& nodesIn(const SurfaceData& s) noexcept
{
  return s.nodes;
}
[[nodiscard]] inline BentNodes nodesIn(const PosedSurface& s) noexcept
{
  return BentNodes(s.shape());
}

/// Walks the two trees of a surface, which are of one shape, for the triangle nearest to the ball among those that may
/// have come over it: a vertex goes straight from old to new, so a triangle never leaves the hull of both its boxes.
/// Of triangles as near as each other it is the first, whatever room the boxes have.
template<class View>
class PassingTriangles
{
public:
  PassingTriangles(const View& before, const View& now, const Vec3& xBefore, const Vec3& xNow, double reach,
    std::uint32_t budget) noexcept
    : before_(before), now_(now), nodesBefore_(nodesIn(before)), nodesNow_(nodesIn(now)), x_(xBefore),
      low_(xBefore.cwiseMin(xNow).array() - reach), high_(xBefore.cwiseMax(xNow).array() + reach), budget_(budget)
  {
  }

  [[nodiscard]] std::optional<std::uint32_t> nearest() noexcept
  {
    const SurfaceData& data = dataOf(this->before_);
    this->stack_[this->top_++] = { data.nodes.empty() ? TreeNode::leafBit : 0u, 0.0 };
    while (this->top_ > 0 && this->visited_++ < this->budget_)
    {
      const Pending next = this->stack_[--this->top_];
      if (next.distance2 <= this->best2_)
      {
        (next.child & TreeNode::leafBit) != 0 ? this->visitLeaf(data.leaves[next.child & ~TreeNode::leafBit])
                                              : this->visitNode(next.child);
      }
    }
    return std::isfinite(this->best2_) ? std::optional(this->triangle_) : std::nullopt;
  }

  /// The same from a list of faces around xBefore, which is x_W in the frame of the list. Nothing where none of them is
  /// so near that it must be the nearest of all: then the trees have to be asked.
  [[nodiscard]] std::optional<std::uint32_t> nearestIn(
    const FaceList& list, std::uint32_t surface, const Vec3& x_W, double tol) noexcept
  {
    const double certain = list.reach().reach_u - (x_W - list.reach().centre_W).norm() - 8 * tol;
    if (certain <= 0.0)
    {
      return std::nullopt;
    }
    SweptBall still = standing({ x_W, certain }, {});
    NearFilter filter(still, list.frame());
    for (int quad = 0; quad < list.quads(); ++quad)
    {
      forEachLane(filter.near(list.discs(quad)) & list.lanesOf(quad),
        [&](std::uint32_t lane) noexcept
        {
          const FaceList::Face& face = list.face(quad * 4 + static_cast<int>(lane));
          if (face.surface == surface)
          {
            this->visitTriangle(face.triangle);
          }
        });
      constexpr double shorter = 0.81; // of squares: from then on a new filter is worth its making
      if (this->best2_ < shorter * still.r * still.r)
      {
        still.r = std::sqrt(this->best2_) + 8 * tol;
        filter = NearFilter(still, list.frame());
      }
    }
    const bool isNearest = this->best2_ < certain * certain;
    this->best2_ = isNearest ? this->best2_ : std::numeric_limits<double>::infinity();
    return isNearest ? std::optional(this->triangle_) : std::nullopt;
  }

private:
  struct Pending
  {
    std::uint32_t child = 0;
    double distance2 = 0.0;
  };

  [[nodiscard]] static double distance2To(const Box& box, const Vec3& x) noexcept
  {
    return (box.low_W - x).cwiseMax(x - box.high_W).cwiseMax(0.0).squaredNorm();
  }

  [[nodiscard]] bool mayPass(const Box& before, const Box& now) const noexcept
  {
    const Vec3 low = before.low_W.cwiseMin(now.low_W), high = before.high_W.cwiseMax(now.high_W);
    return (low.array() <= this->high_.array()).all() && (high.array() >= this->low_.array()).all();
  }

  void visitNode(std::uint32_t index) noexcept
  {
    const TreeNode &before = this->nodesBefore_[index], &now = this->nodesNow_[index];
    std::array<Pending, 2> children;
    int count = 0;
    for (std::size_t k = 0; k < 2; ++k)
    {
      const Box old = boxOf(before, k);
      if (this->mayPass(old, boxOf(now, k)))
      {
        children[static_cast<std::size_t>(count++)] = { before.child[k], distance2To(old, this->x_) };
      }
    }
    if (count == 2 && children[0].distance2 < children[1].distance2)
    {
      std::swap(children[0], children[1]);
    }
    std::copy_n(children.begin(), count, this->stack_.begin() + this->top_);
    this->top_ += count;
  }

  void visitLeaf(const Leaf& leaf) noexcept
  {
    for (std::uint32_t t = leaf.first; t < leaf.first + leaf.count; ++t)
    {
      this->visitTriangle(t);
    }
  }

  void visitTriangle(std::uint32_t t) noexcept
  {
    const auto& old = ownCorners(this->before_, t);
    if (distance2To(boxOf(old), this->x_) > this->best2_)
    {
      return;
    }
    const double distance2 = (this->x_ - nearestOnTriangle(this->x_, old[0], old[1], old[2])).squaredNorm();
    const bool nearer = distance2 < this->best2_ || (distance2 == this->best2_ && t < this->triangle_);
    if (nearer && this->mayPass(boxOf(old), boxOf(ownCorners(this->now_, t))))
    {
      this->best2_ = distance2;
      this->triangle_ = t;
    }
  }

  const View& before_;
  const View& now_;
  decltype(nodesIn(std::declval<const View&>())) nodesBefore_, nodesNow_;
  Vec3 x_, low_, high_;
  std::uint32_t budget_;
  std::uint32_t visited_ = 0;
  std::array<Pending, mostPending> stack_;
  int top_ = 0;
  double best2_ = std::numeric_limits<double>::infinity();
  std::uint32_t triangle_ = 0;
};

} // namespace palpate
