// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/servo/StandingGuard.h"

#include <algorithm>

#include "haptics/geometry/tree/TreeWalk.h"
#include "haptics/tool/certify/PairProof.h"

namespace palpate
{
namespace
{

/// A part of the motion no longer than that share of it is not divided, nor one in which no point goes as far as
/// triangles stay apart.
constexpr double coarsest = 1.0 / 64.0;
/// Cosine between a triangle's outer normal and the way to one that is behind it.
constexpr double behind = -0.5;

Vec3 sizeOf(const Box& box) noexcept
{
  return box.high_W - box.low_W;
}

bool apart(const Box& a, const Box& b) noexcept
{
  return ((a.low_W - b.high_W).cwiseMax(b.low_W - a.high_W)).maxCoeff() > 0.0;
}

/// A node of a tree, or a leaf, with its box.
struct Part
{
  std::uint32_t child = 0;
  Box box;

  [[nodiscard]] bool isLeaf() const noexcept { return (this->child & TreeNode::leafBit) != 0; }
  [[nodiscard]] std::uint32_t leaf() const noexcept { return this->child & ~TreeNode::leafBit; }
};

Part rootOf(const SurfaceData& data) noexcept
{
  return { data.nodes.empty() ? TreeNode::leafBit : 0u, { data.low_W, data.high_W } };
}

/// Distances of a proof [u].
struct GuardLimits
{
  double most_u = 0.0; ///< no point goes further, with the gap
  double gap_u = 0.0;
  double same_u = 0.0; ///< places that are nearer are one
};

/// The mesh in the hand and one that stands, over one motion.
class GuardedPair
{
public:
  GuardedPair(const StandingMeshes& meshes, int mesh, const ScrewStep& way, const GuardLimits& limits,
    WorkBudget& budget, FreeWay& free) noexcept
    : held_(meshes.held()), sided_(meshes.standing(mesh)), standing_(sided_.tree->data()), mesh_(mesh), way_(way),
      limits_(limits), finest_(std::min(coarsest, limits.gap_u / std::max(limits.most_u, limits.gap_u))),
      budget_(budget), free_(free), turn_(way.from_W.q.toRotationMatrix()), size_(turn_.cwiseAbs())
  {
  }

  /// False where the work was used up.
  [[nodiscard]] bool look() noexcept
  {
    std::array<std::array<Part, 2>, 2 * static_cast<std::size_t>(mostPending)> stack;
    std::size_t top = 0;
    stack[top++] = { rootOf(this->held_), rootOf(this->standing_) };
    while (top > 0)
    {
      const std::array<Part, 2> pair = stack[--top];
      if (!this->budget_.spend())
      {
        return false;
      }
      if (apart(this->around_W(pair[0].box), pair[1].box))
      {
        continue;
      }
      if (pair[0].isLeaf() && pair[1].isLeaf())
      {
        if (!this->lookAtLeaves(pair[0].leaf(), pair[1].leaf()))
        {
          return false;
        }
        continue;
      }
      const bool ofHeld = !pair[0].isLeaf() &&
                          (pair[1].isLeaf() || sizeOf(pair[0].box).squaredNorm() > sizeOf(pair[1].box).squaredNorm());
      const std::size_t side = ofHeld ? 0 : 1;
      const TreeNode& node = (ofHeld ? this->held_ : this->standing_).nodes[pair[side].child];
      for (std::size_t k = 0; k < 2; ++k)
      {
        stack[top] = pair;
        stack[top++][side] = { node.child[k], boxOf(node, k) };
      }
    }
    return true;
  }

private:
  /// Of a box of the mesh in the hand, and its motion.
  [[nodiscard]] Box around_W(const Box& box) const noexcept
  {
    const Vec3 centre_W = this->way_.from_W.p + this->turn_ * (0.5 * (box.low_W + box.high_W));
    const Vec3 half_W = (this->size_ * (0.5 * sizeOf(box))).array() + this->limits_.most_u;
    return { centre_W - half_W, centre_W + half_W };
  }

  [[nodiscard]] Corners armsOf(std::uint32_t triangle) const noexcept
  {
    const auto corners = this->held_.cornersOf(triangle);
    return { this->turn_ * corners[0], this->turn_ * corners[1], this->turn_ * corners[2] };
  }

  [[nodiscard]] Corners at_W(const Corners& arms_W, double share) const noexcept
  {
    const Mat3 turn = this->way_.turn(share);
    const Vec3 centre_W = this->way_.centre_W(share);
    return { centre_W + turn * arms_W[0], centre_W + turn * arms_W[1], centre_W + turn * arms_W[2] };
  }

  [[nodiscard]] bool lookAtLeaves(std::uint32_t ofHeld, std::uint32_t ofStanding) noexcept
  {
    bool within = true;
    this->held_.forEachInLeaf(ofHeld,
      [&](std::uint32_t t)
      {
        const Corners arms_W = this->armsOf(t);
        const Corners tool_W = this->at_W(arms_W, 0.0);
        this->standing_.forEachInLeaf(ofStanding,
          [&](std::uint32_t s)
          {
            const Corners scene_W = this->standing_.cornersOf(s);
            if (within && boxesApart_u(tool_W, scene_W) <= this->limits_.most_u)
            {
              within = this->lookAt({ arms_W, scene_W }, tool_W, s);
            }
          });
      });
    return within;
  }

  /// Triangles that were nearer than the gap already keep half of their distance: they never come to nothing. Those
  /// that meet already belong to a mesh that began in the other one, and may leave it.
  [[nodiscard]] bool lookAt(const MovingPair& pair, const Corners& tool_W, std::uint32_t triangle) noexcept
  {
    const double until = std::min(1.0, this->free_.share + this->finest_);
    double share = this->provenUntil(pair, this->limits_.gap_u, until);
    if (share <= 0.0)
    {
      const double start_u = nearestPair(tool_W, pair.scene_W).distance_u;
      share = start_u > 0.0 ? this->provenUntil(pair, std::min(this->limits_.gap_u, 0.5 * start_u), until) : until;
    }
    if (until > share && this->budget_.left() > 0)
    {
      this->see(pair, share, triangle);
    }
    return this->budget_.left() > 0;
  }

  /// Where the motion is proven no further, all corners of a triangle may be as near: the one that comes nearer is seen
  /// later. There both may be a little in one another, so that their sides are those of where they are apart.
  void see(const MovingPair& pair, double share, std::uint32_t triangle) noexcept
  {
    constexpr int most = 16;
    const Vec3 n_W = nearestPair(this->at_W(pair.arms_W, share), pair.scene_W).n;
    if (n_W.dot(this->sided_.side[triangle] * this->standing_.plane(triangle).normal_W) < behind)
    {
      return;
    }
    MetPlace met{ this->mesh_, share, std::min(share + this->finest_, 1.0), {} };
    met.at = nearestPair(this->at_W(pair.arms_W, met.seen), pair.scene_W);
    for (int tries = 0; tries < most && met.at.distance_u <= 0.0; ++tries)
    {
      met.seen = tries + 1 < most ? 0.5 * (share + met.seen) : share;
      met.at = nearestPair(this->at_W(pair.arms_W, met.seen), pair.scene_W);
    }
    met.at.n = n_W.dot(met.at.n) < 0.0 ? Vec3(-met.at.n) : met.at.n;
    this->keep(met);
  }

  void keep(const MetPlace& met) noexcept
  {
    FreeWay& free = this->free_;
    const auto isLater = [&](const MetPlace& other) { return other.share > met.share + this->finest_; };
    const auto isSame = [&](const MetPlace& other)
    {
      return other.mesh == met.mesh && other.at.n.dot(met.at.n) > StandingGuard::sameNormal &&
             (other.at.onTool_W - met.at.onTool_W).norm() < this->limits_.same_u;
    };
    const auto last = std::remove_if(free.met.begin(), free.met.begin() + free.count, isLater);
    free.count = static_cast<int>(last - free.met.begin());
    free.share = std::min(free.share, met.share);
    if (free.count < FreeWay::most && std::none_of(free.met.begin(), last, isSame))
    {
      free.met[static_cast<std::size_t>(free.count++)] = met;
    }
  }

  [[nodiscard]] double provenUntil(const MovingPair& pair, double gap_u, double until) noexcept
  {
    CachedPlane plane;
    return PairProof(this->way_, { gap_u, this->finest_ }, this->budget_).provenUntil(pair, until, plane);
  }

  const SurfaceData& held_;
  const SidedSurface& sided_;
  const SurfaceData& standing_;
  int mesh_;
  const ScrewStep& way_;
  GuardLimits limits_;
  double finest_; ///< share of the motion
  WorkBudget& budget_;
  FreeWay& free_;
  Mat3 turn_, size_;
};

} // namespace

ScrewStep wayOf(const Pose& from_W, const Pose& to_W) noexcept
{
  return { from_W, to_W.p - from_W.p, turnFromTo(from_W.q, to_W.q) };
}

StandingGuard::StandingGuard(const StandingMeshes* meshes) noexcept : meshes_(meshes)
{
  if (this->guards())
  {
    const SurfaceData& held = this->meshes_->held();
    this->size_u_ = (held.high_W - held.low_W).norm();
    this->reach_u_ = held.low_W.cwiseAbs().cwiseMax(held.high_W.cwiseAbs()).norm();
  }
}

FreeWay StandingGuard::look(const ScrewStep& way, WorkBudget& budget) const noexcept
{
  FreeWay free;
  const GuardLimits limits{ way.displacement_u(this->reach_u_) + this->rest_u(), gap * this->size_u_,
    this->samePlace_u() };
  for (int mesh = 0; mesh < this->meshes_->count() && !free.spent; ++mesh)
  {
    free.spent = !GuardedPair(*this->meshes_, mesh, way, limits, budget, free).look();
  }
  return free;
}

} // namespace palpate
