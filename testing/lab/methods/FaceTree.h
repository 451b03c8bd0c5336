// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "haptics/geometry/mesh/TriangleMesh.h"
#include "testing/lab/methods/RayCaster.h"

namespace palpate::lab
{

/// The questions that textbook methods ask of a mesh: nearest face, faces around, first face on a segment. A plain CGAL
/// AABB tree in double precision; triangles that are not finite or have no area are left out, all else is taken as it
/// comes.
class FaceTree final : public RayCaster
{
public:
  explicit FaceTree(const TriangleMesh& mesh);
  ~FaceTree() override;
  FaceTree(const FaceTree&) = delete;
  FaceTree& operator=(const FaceTree&) = delete;

  /// The face nearest to p_W.
  [[nodiscard]] Face nearest(const Vec3& p_W) const;
  /// The nearest `most` faces within reach_u of p_W, nearest first.
  [[nodiscard]] std::vector<Face> within(const Vec3& p_W, double reach_u, std::size_t most) const;
  /// A segment that begins on a face leaves that face out.
  [[nodiscard]] std::optional<Face> firstHit(const Vec3& from_W, const Vec3& to_W) const override;

private:
  struct Tree;
  std::unique_ptr<const Tree> tree_;
};

} // namespace palpate::lab
