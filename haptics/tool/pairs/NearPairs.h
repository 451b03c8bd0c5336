// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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
  bool split = false;                             ///< its triangles are looked at one by one
};

/// Two triangles of a leaf pair that no plane separates as a whole.
struct NearTriangles
{
  std::uint32_t toolTriangle = 0, sceneTriangle = 0;
  CachedPlane plane;
};

/// What is near, as a step is proven against it. The tool's corners are turned and moved once a step, for all.
class NearPairs
{
public:
  NearPairs(const BoxedMesh& tool_B, const BoxedMesh& scene_W);

  void rebuild(const std::vector<BoxPair>& near);
  [[nodiscard]] std::vector<LeafPair>& leaves() noexcept { return this->leaves_; }
  [[nodiscard]] const std::vector<LeafPair>& leaves() const noexcept { return this->leaves_; }
  [[nodiscard]] std::vector<NearTriangles>& triangles() noexcept { return this->triangles_; }
  [[nodiscard]] const std::vector<NearTriangles>& triangles() const noexcept { return this->triangles_; }

  /// From here on all corners are told for this step.
  void setStep(const ScrewStep& step);
  /// How a plane keeps two leaves apart over the whole step.
  [[nodiscard]] SpanGap gapOf(const LeafPair& pair, const Vec3& n_W, double below_u) const noexcept;
  [[nodiscard]] SpanGap gapOf(const LeafPair& pair) const noexcept { return this->gapOf(pair, pair.n_W, pair.below_u); }
  /// Takes the best plane there is for the first share of the step. True if it leaves the gap free.
  bool findPlane(LeafPair& pair, double share, double gap_u) const noexcept;
  /// From now on the triangles of the pair are looked at one by one. They are appended to triangles().
  void split(LeafPair& pair);

  [[nodiscard]] MovingPair moving(std::uint32_t toolTriangle, std::uint32_t sceneTriangle) const noexcept;
  /// The tool's triangle after a share of the step.
  [[nodiscard]] Corners toolAt_W(std::uint32_t triangle, const Mat3& turn, const Vec3& centre_W) const noexcept;

private:
  struct LeafRange
  {
    std::uint32_t stamp = 0, first = 0, count = 0;
  };
  [[nodiscard]] LeafRange verticesOf(std::uint32_t toolNode);
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
  std::vector<Vec3> body_B_, arms_W_, ends_W_; ///< of the corners in use; ends: arms after the step
  std::vector<double> along_;                  ///< w . arm
  ScrewStep step_;
  Mat3 start_ = Mat3::Identity();
};

} // namespace palpate
