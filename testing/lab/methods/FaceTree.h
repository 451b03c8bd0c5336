// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "haptics/geometry/mesh/TriangleMesh.h"

namespace palpate::lab
{

/// A face as a textbook method sees it.
struct Face
{
  std::size_t index = 0;
  Vec3 point_W = Vec3::Zero();   ///< the point of it that was asked for: nearest, or hit
  Vec3 normal_W = Vec3::UnitZ(); ///< unit, right-handed for the stored corners
};

/// What textbook methods ask of a mesh: nearest face, faces around, first face on a way. A plain CGAL AABB tree in
/// double precision; triangles that are not finite or have no area are left out, all else is taken as it comes.
class FaceTree
{
public:
  explicit FaceTree(const TriangleMesh& mesh);
  ~FaceTree();
  FaceTree(const FaceTree&) = delete;
  FaceTree& operator=(const FaceTree&) = delete;

  /// The face nearest to p_W.
  [[nodiscard]] Face nearest(const Vec3& p_W) const;
  /// The nearest `most` faces within reach_u of p_W, nearest first.
  [[nodiscard]] std::vector<Face> within(const Vec3& p_W, double reach_u, std::size_t most) const;
  /// The first face the segment crosses from its front or its back. A way that begins on a face leaves it out.
  [[nodiscard]] std::optional<Face> firstHit(const Vec3& from_W, const Vec3& to_W) const;

private:
  struct Tree;
  std::unique_ptr<const Tree> tree_;
};

} // namespace palpate::lab
