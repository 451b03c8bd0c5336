// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "haptics/tool/certify/PairProof.h"
#include "haptics/tool/pairs/PairFront.h"

namespace palpate
{

/// The gap of a pair along its plane over a step, until the tool has made that step.
struct StepGap
{
  SpanGap gap;
  std::uint64_t step = 0; ///< NearPairs' number of the step; 0: none
};

/// Two leaves that are near, with one plane of the scene between them if there is one.
struct LeafPair
{
  std::uint32_t toolNode = 0, sceneNode = 0;
  std::uint32_t firstVertex = 0, vertexCount = 0; ///< of NearPairs::leafVertices
  Vec3 n_W = Vec3::Zero();                        ///< zero: no plane is known
  double below_u = 0.0;                           ///< largest height of the scene's leaf along n
  double key_u = 0.0;                             ///< known gap, plus the path length of the tool at that time
  StepGap stepped;                                ///< along its plane
  bool split = false;                             ///< its triangles are examined one by one
  bool featureless = false;                       ///< all flat, on both sides: no feature of it can touch
};

/// Two triangles of a leaf pair that no plane separates as a whole.
struct NearTriangles
{
  std::uint32_t toolTriangle = 0, sceneTriangle = 0;
  std::array<std::uint32_t, 3> vertices{}; ///< the tool's, as numbers of the corners in use
  CachedPlane plane;
  double key_u = 0.0; ///< likewise
  StepGap stepped;    ///< likewise
};

/// The near pairs, against which a step is proven. The tool's corners are posed once per step, for all pairs.
class NearPairs
{
public:
  NearPairs(const BoxedMesh& tool_B, const BoxedMesh& scene_W);

  /// `way_u`: path length of the tool until now, to which the keys refer. `margin_u`: pairs further away are not in the
  /// list.
  void rebuild(const std::vector<BoxPair>& near, double way_u, double margin_u);
  /// The tool was put elsewhere, or its path length is counted anew: no gap is known.
  void forget();
  [[nodiscard]] std::vector<LeafPair>& leaves() noexcept { return this->leaves_; }
  [[nodiscard]] const std::vector<LeafPair>& leaves() const noexcept { return this->leaves_; }
  [[nodiscard]] std::vector<NearTriangles>& triangles() noexcept { return this->triangles_; }
  [[nodiscard]] const std::vector<NearTriangles>& triangles() const noexcept { return this->triangles_; }

  /// From here on all corners are posed for this step, which the tool makes after `way_u`.
  void setStep(const ScrewStep& step, double way_u);
  /// A lower bound of a gap at the pose of the tool, from earlier bounds.
  template<class AnyPair>
  [[nodiscard]] double knownGap_u(const AnyPair& pair) const noexcept
  {
    return pair.key_u - this->way_u_;
  }
  /// Notes a gap at the pose of the tool that a plane has shown.
  template<class AnyPair>
  void learn(AnyPair& pair, double gap_u) const noexcept
  {
    pair.key_u = std::max(pair.key_u, this->way_u_ + gap_u);
  }
  /// Notes the gap along a plane over the step.
  template<class AnyPair>
  void learn(AnyPair& pair, const SpanGap& gap) const noexcept
  {
    this->learn(pair, gap.from);
    pair.stepped = { gap, this->steps_ };
  }
  /// The tool made this share of the step: gaps that planes showed are known at its new pose, `way_u` along its path.
  /// Without this each pair would be as near as the motion is long, also one that slides along its plane.
  void made(double share, double way_u) noexcept;
  /// The gap along the plane between two leaves over the whole step.
  [[nodiscard]] SpanGap gapOf(const LeafPair& pair) noexcept
  {
    return this->gapOver(this->verticesOf(pair), pair.n_W, pair.below_u);
  }
  /// Likewise for two triangles, along a plane of the scene.
  [[nodiscard]] SpanGap gapOf(const NearTriangles& pair, const Vec3& n_W) noexcept;
  /// Takes the best plane for the first `share` of the step. True if it leaves the gap free.
  bool findPlane(LeafPair& pair, double share, double gap_u) noexcept;
  /// From now on the triangles of the pair are examined one by one. They are appended to triangles().
  void split(LeafPair& pair);

  [[nodiscard]] MovingPair moving(const NearTriangles& pair) noexcept;
  /// A triangle of the tool at this pose.
  [[nodiscard]] Corners toolAt_W(std::uint32_t triangle, const Mat3& turn, const Vec3& centre_W) const noexcept;

private:
  /// Data of a leaf pair that was near before: most of these are near again.
  struct KnownLeaf
  {
    std::uint32_t toolNode = 0, sceneNode = 0;
    Vec3 n_W = Vec3::Zero();
    double below_u = 0.0;
    double key_u = 0.0;
  };
  /// Likewise for two triangles.
  struct KnownTriangles
  {
    std::uint32_t toolTriangle = 0, sceneTriangle = 0;
    CachedPlane plane;
    double key_u = 0.0;
  };
  /// A corner of the tool that is in use, posed on demand: most pairs are known to be far enough.
  struct UsedCorner
  {
    Vec3 body_B = Vec3::Zero(), arm_W = Vec3::Zero();
    Vec3 end_W = Vec3::Zero();        ///< the arm after the step
    double along = 0.0;               ///< w . arm
    std::uint64_t pose = 0, step = 0; ///< for which they were computed
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
  /// The gap of these corners of the tool above a plane.
  [[nodiscard]] SpanGap gapOver(std::span<const std::uint32_t> vertices, const Vec3& n_W, double below_u) noexcept;
  [[nodiscard]] KnownLeaf& known(const LeafPair& pair) noexcept;
  [[nodiscard]] KnownTriangles& known(const NearTriangles& pair) noexcept;
  void remember();
  void recall(LeafPair& pair) noexcept;
  void recall(NearTriangles& pair) noexcept;
  [[nodiscard]] bool isFeatureless(const LeafPair& pair) const noexcept;
  /// The extent of the scene's leaf along an axis.
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
  std::uint64_t poses_ = 1, steps_ = 1;        ///< counted until now
  std::vector<KnownLeaf> knownLeaves_;         ///< by a hash of both nodes
  std::vector<KnownTriangles> knownTriangles_; ///< by a hash of both triangles
  bool knows_ = false;                         ///< whether the two have any data
  ScrewStep step_;
  double way_u_ = 0.0, listed_u_ = 0.0;
  Mat3 start_ = Mat3::Identity(), end_ = Mat3::Identity();
};

} // namespace palpate
