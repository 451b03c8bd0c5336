// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
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
    : before_(before), now_(now), x_(xBefore), reach_(reach), low_(xBefore.cwiseMin(xNow).array() - reach),
      high_(xBefore.cwiseMax(xNow).array() + reach), budget_(budget)
  {
  }

  [[nodiscard]] std::optional<std::uint32_t> nearest() noexcept
  {
    const SurfaceData& data = dataOf(this->before_);
    const auto &nodesBefore = nodesIn(this->before_), &nodesNow = nodesIn(this->now_);
    this->stack_[this->top_++] = { data.nodes.empty() ? TreeNode::leafBit : 0u, 0.0 };
    while (this->top_ > 0 && this->visited_++ < this->budget_)
    {
      const Pending next = this->stack_[--this->top_];
      if (next.distance2 <= this->best2_)
      {
        (next.child & TreeNode::leafBit) != 0 ? this->visitLeaf(data.leaves[next.child & ~TreeNode::leafBit])
                                              : this->visitNode(nodesBefore[next.child], nodesNow[next.child]);
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
    // A ball that touches something has its nearest triangle within reach, and few others.
    this->visitListed(list, surface, { x_W, std::min(certain, this->reach_ + 8 * tol) }, tol);
    const double told = 1e6 * tol; // at a distance of less rounding decides which face a way meets
    this->allAlike_ = this->allAlike_ && this->best2_ > told * told && this->best2_ <= this->reach_ * this->reach_ &&
                      this->reach_ < certain;
    if (this->best2_ > this->reach_ * this->reach_)
    {
      this->visitListed(list, surface, { x_W, certain }, tol);
    }
    const bool isNearest = this->best2_ < certain * certain;
    this->best2_ = isNearest ? this->best2_ : std::numeric_limits<double>::infinity();
    return isNearest ? std::optional(this->triangle_) : std::nullopt;
  }

  /// After nearestIn(): the nearest triangle and all of the scene that are about as near, which a way to the nearest
  /// point can meet; none where they are not known.
  [[nodiscard]] std::span<const std::uint32_t> alike() const noexcept
  {
    return { this->alike_.data(), this->allAlike_ ? this->alikeCount_ : 0 };
  }
  static constexpr std::size_t mostAlike = 8; ///< a vertex has six triangles mostly

private:
  /// A triangle whose squared distance is larger by no more is about as near.
  static constexpr double aboutAsNear = 1.0 + 1e-5;

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

  void visitNode(const TreeNode& before, const TreeNode& now) noexcept
  {
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

  void visitListed(const FaceList& list, std::uint32_t surface, const Reach& reach, double tol) noexcept
  {
    SweptBall still = standing(reach, {});
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
          this->allAlike_ = this->allAlike_ && face.surface == surface;
        });
      constexpr double shorter = 0.81; // of squares: from then on a new filter is worth its making
      if (this->best2_ < shorter * still.r * still.r)
      {
        still.r = aboutAsNear * std::sqrt(this->best2_) + 8 * tol;
        filter = NearFilter(still, list.frame());
      }
    }
  }

  void noteAlike(std::uint32_t t, double distance2) noexcept
  {
    if (distance2 <= aboutAsNear * this->best2_)
    {
      this->allAlike_ = this->allAlike_ && this->alikeCount_ < mostAlike;
      this->alikeCount_ = this->allAlike_ ? this->alikeCount_ : 0;
      this->alike_[this->alikeCount_] = t;
      this->alikeDistances2_[this->alikeCount_++] = distance2;
    }
  }

  void dropFurther() noexcept
  {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < this->alikeCount_; ++i)
    {
      if (this->alikeDistances2_[i] <= aboutAsNear * this->best2_)
      {
        this->alike_[kept] = this->alike_[i];
        this->alikeDistances2_[kept++] = this->alikeDistances2_[i];
      }
    }
    this->alikeCount_ = kept;
  }

  void visitTriangle(std::uint32_t t) noexcept
  {
    const auto& old = ownCorners(this->before_, t);
    if (distance2To(boxOf(old), this->x_) > aboutAsNear * this->best2_)
    {
      return;
    }
    const double distance2 = (this->x_ - nearestOnTriangle(this->x_, old[0], old[1], old[2])).squaredNorm();
    const bool nearer = distance2 < this->best2_ || (distance2 == this->best2_ && t < this->triangle_);
    if (nearer && this->mayPass(boxOf(old), boxOf(ownCorners(this->now_, t))))
    {
      this->best2_ = distance2;
      this->triangle_ = t;
      this->dropFurther();
    }
    this->noteAlike(t, distance2);
  }

  const View& before_;
  const View& now_;
  Vec3 x_;
  double reach_;
  Vec3 low_, high_;
  std::uint32_t budget_;
  std::uint32_t visited_ = 0;
  std::array<Pending, mostPending> stack_;
  int top_ = 0;
  double best2_ = std::numeric_limits<double>::infinity();
  std::uint32_t triangle_ = 0;
  bool allAlike_ = true; ///< no other surface is about as near, and there is room for all
  std::size_t alikeCount_ = 0;
  std::array<std::uint32_t, mostAlike> alike_;
  std::array<double, mostAlike> alikeDistances2_;
};

} // namespace palpate
