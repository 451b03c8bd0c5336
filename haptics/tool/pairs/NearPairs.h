// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "haptics/tool/certify/PairProof.h"
#include "haptics/tool/pairs/PairFront.h"

namespace palpate
{

/// Two leaves that are near, with one plane of the scene between them as long as there is one.
struct LeafPair
{
  std::uint32_t toolNode = 0, sceneNode = 0;
  std::uint32_t firstVertex = 0, vertexCount = 0; ///< of NearPairs::leafVertices
  Vec3 n_W = Vec3::Zero();                        ///< zero: no plane is known
  double below_u = 0.0;                           ///< no corner of the scene's leaf lies further along n
  double key_u = 0.0;                             ///< gap that is known, plus the way of the tool when it was
  bool split = false;                             ///< its triangles are looked at one by one
  bool featureless = false;                       ///< all flat, on both sides: nothing of it can be what touches
};

/// Two triangles of a leaf pair that no plane separates as a whole.
struct NearTriangles
{
  std::uint32_t toolTriangle = 0, sceneTriangle = 0;
  std::array<std::uint32_t, 3> vertices{}; ///< the tool's, as numbers of the corners in use
  CachedPlane plane;
  double key_u = 0.0; ///< likewise
};

/// What is near, as a step is proven against it. The tool's corners are turned and moved once a step, for all.
class NearPairs
{
public:
  NearPairs(const BoxedMesh& tool_B, const BoxedMesh& scene_W);

  /// `way_u`: of the tool until now, by which the keys are counted. `margin_u`: what is further away is not in the
  /// list.
  void rebuild(const std::vector<BoxPair>& near, double way_u, double margin_u);
  /// The tool stands elsewhere, or its way is counted anew: nothing is known of any gap.
  void forget();
  [[nodiscard]] std::vector<LeafPair>& leaves() noexcept { return this->leaves_; }
  [[nodiscard]] const std::vector<LeafPair>& leaves() const noexcept { return this->leaves_; }
  [[nodiscard]] std::vector<NearTriangles>& triangles() noexcept { return this->triangles_; }
  [[nodiscard]] const std::vector<NearTriangles>& triangles() const noexcept { return this->triangles_; }

  /// From here on all corners are told for this step, that the tool makes after `way_u`.
  void setStep(const ScrewStep& step, double way_u);
  /// A lower bound of a gap where the tool stands, from what was known of it before.
  template<class AnyPair>
  [[nodiscard]] double knownGap_u(const AnyPair& pair) const noexcept
  {
    return pair.key_u - this->way_u_;
  }
  /// A gap where the tool stands that a plane has shown.
  template<class AnyPair>
  void learn(AnyPair& pair, double gap_u) const noexcept
  {
    pair.key_u = std::max(pair.key_u, this->way_u_ + gap_u);
  }
  /// How a plane keeps two leaves apart over the whole step.
  [[nodiscard]] SpanGap gapOf(const LeafPair& pair) noexcept
  {
    return this->gapOver(this->verticesOf(pair), pair.n_W, pair.below_u);
  }
  /// Likewise two triangles, by a plane of the scene.
  [[nodiscard]] SpanGap gapOf(const NearTriangles& pair, const Vec3& n_W) noexcept;
  /// Takes the best plane there is for the first share of the step. True if it leaves the gap free.
  bool findPlane(LeafPair& pair, double share, double gap_u) noexcept;
  /// From now on the triangles of the pair are looked at one by one. They are appended to triangles().
  void split(LeafPair& pair);

  [[nodiscard]] MovingPair moving(const NearTriangles& pair) noexcept;
  /// The tool's triangle after a share of the step.
  [[nodiscard]] Corners toolAt_W(std::uint32_t triangle, const Mat3& turn, const Vec3& centre_W) const noexcept;

private:
  /// What is known of a leaf pair that was near before: most of them are near again.
  struct KnownLeaf
  {
    std::uint32_t toolNode = 0, sceneNode = 0;
    Vec3 n_W = Vec3::Zero();
    double below_u = 0.0;
    double key_u = 0.0;
  };
  /// Likewise of two triangles.
  struct KnownTriangles
  {
    std::uint32_t toolTriangle = 0, sceneTriangle = 0;
    CachedPlane plane;
    double key_u = 0.0;
  };
  /// A corner of the tool that is in use, posed when it is asked for: most pairs are known to be far enough.
  struct UsedCorner
  {
    Vec3 body_B = Vec3::Zero(), arm_W = Vec3::Zero();
    Vec3 end_W = Vec3::Zero();        ///< the arm after the step
    double along = 0.0;               ///< w . arm
    std::uint64_t pose = 0, step = 0; ///< that they are of
  };
  [[nodiscard]] const UsedCorner& at(std::uint32_t corner) noexcept;
  struct LeafRange
  {
    std::uint32_t stamp = 0, first = 0, count = 0;
  };
  [[nodiscard]] LeafRange verticesOf(std::uint32_t toolNode);
  [[nodiscard]] std::span<const std::uint32_t> verticesOf(const LeafPair& pair) const noexcept
  {
    return { this->leafVertices_.data() + pair.firstVertex, pair.vertexCount };
  }
  /// Of these corners of the tool above a plane.
  [[nodiscard]] SpanGap gapOver(std::span<const std::uint32_t> vertices, const Vec3& n_W, double below_u) noexcept;
  [[nodiscard]] KnownLeaf& known(const LeafPair& pair) noexcept;
  [[nodiscard]] KnownTriangles& known(const NearTriangles& pair) noexcept;
  void remember();
  void recall(LeafPair& pair) noexcept;
  void recall(NearTriangles& pair) noexcept;
  [[nodiscard]] bool isFeatureless(const LeafPair& pair) const noexcept;
  /// Of the scene's leaf along an axis.
  struct Extent
  {
    double low = std::numeric_limits<double>::infinity(), high = -low;
  };
  [[nodiscard]] Extent extentOf(const LeafPair& pair, const Vec3& axis) const noexcept;
  [[nodiscard]] std::array<Vec3, 3> candidates(const LeafPair& pair) const noexcept;

  const BoxedMesh& tool_B_;
  const BoxedMesh& scene_W_;
  std::vector<LeafPair> leaves_;
  std::vector<NearTriangles> triangles_;
  std::vector<std::uint32_t> leafVertices_;       ///< of the tool's leaves, as numbers of corners_
  std::vector<LeafRange> leafRange_;              ///< by node of the tool
  std::vector<std::uint32_t> local_, localStamp_; ///< by vertex of the tool
  std::uint32_t stamp_ = 0;
  std::vector<UsedCorner> corners_;
  std::uint64_t poses_ = 1, steps_ = 1;        ///< until now
  std::vector<KnownLeaf> knownLeaves_;         ///< by a hash of both nodes
  std::vector<KnownTriangles> knownTriangles_; ///< by a hash of both triangles
  bool knows_ = false;                         ///< there is anything in the two
  ScrewStep step_;
  double way_u_ = 0.0, listed_u_ = 0.0;
  Mat3 start_ = Mat3::Identity(), end_ = Mat3::Identity();
};

} // namespace palpate
