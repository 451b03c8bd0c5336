// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

  /// `way_u`: of the tool until now, by which the keys are counted.
  void rebuild(const std::vector<BoxPair>& near, double way_u);
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
  [[nodiscard]] SpanGap gapOf(const LeafPair& pair) const noexcept
  {
    return this->gapOver(this->verticesOf(pair), pair.n_W, pair.below_u);
  }
  /// Likewise two triangles, by a plane of the scene.
  [[nodiscard]] SpanGap gapOf(const NearTriangles& pair, const Vec3& n_W) const noexcept;
  /// Takes the best plane there is for the first share of the step. True if it leaves the gap free.
  bool findPlane(LeafPair& pair, double share, double gap_u) const noexcept;
  /// From now on the triangles of the pair are looked at one by one. They are appended to triangles().
  void split(LeafPair& pair);

  [[nodiscard]] MovingPair moving(const NearTriangles& pair) const noexcept;
  /// The tool's triangle after a share of the step.
  [[nodiscard]] Corners toolAt_W(std::uint32_t triangle, const Mat3& turn, const Vec3& centre_W) const noexcept;

private:
  /// The plane of a leaf pair that was near before: most of them are near again.
  struct KnownPlane
  {
    std::uint32_t toolNode = 0, sceneNode = 0;
    Vec3 n_W = Vec3::Zero();
    double below_u = 0.0;
  };
  void turnArms(const Quat& turn);
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
  [[nodiscard]] SpanGap gapOver(
    std::span<const std::uint32_t> vertices, const Vec3& n_W, double below_u) const noexcept;
  [[nodiscard]] KnownPlane& knownPlane(const LeafPair& pair) noexcept;
  void recall(LeafPair& pair) noexcept;
  [[nodiscard]] bool isFeatureless(const LeafPair& pair) const noexcept;
  [[nodiscard]] double belowOf(const LeafPair& pair, const Vec3& n_W) const noexcept;
  [[nodiscard]] std::array<Vec3, 3> candidates(const LeafPair& pair) const noexcept;

  const BoxedMesh& tool_B_;
  const BoxedMesh& scene_W_;
  std::vector<LeafPair> leaves_;
  std::vector<NearTriangles> triangles_;
  std::vector<std::uint32_t> leafVertices_;       ///< of the tool's leaves, as numbers of body_
  std::vector<LeafRange> leafRange_;              ///< by node of the tool
  std::vector<std::uint32_t> local_, localStamp_; ///< by vertex of the tool
  std::uint32_t stamp_ = 0;
  std::uint32_t armsOf_ = 0;                   ///< stamp of the corners that arms_W_ has
  std::vector<Vec3> body_B_, arms_W_, ends_W_; ///< of the corners in use; ends: arms after the step
  std::vector<double> along_;                  ///< w . arm
  std::vector<KnownPlane> known_;              ///< by a hash of both nodes
  ScrewStep step_;
  double way_u_ = 0.0;
  Mat3 start_ = Mat3::Identity();
};

} // namespace palpate
