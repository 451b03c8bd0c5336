// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "haptics/geometry/tree/SurfaceData.h"

namespace palpate
{

/// Data of a surface that depend on the positions of its vertices, beside the hierarchy: shared by building and
/// refitting. Internal to haptics/geometry.

/// From this FaceRecord::sliver on a normal is computed exactly, for its rounding error is 1e-8 and more.
inline constexpr float needleSliver = 1e8F;

/// Corners, normal (zero for a segment) and sliver of a triangle of data.mesh; `owned` is the caller's.
[[nodiscard]] FaceRecord makeFace(const SurfaceData& data, std::uint32_t triangle, std::uint32_t owned) noexcept;

/// The same for corners at other positions.
[[nodiscard]] FaceRecord makeFace(const std::array<Vec3, 3>& corners_W, bool segment, std::uint32_t owned) noexcept;

/// A disc in a triangle's plane that holds its three corners: the circle over the longest edge, or round the centroid.
struct Disc
{
  Vec3 centre_W;
  double radius_u;
};
[[nodiscard]] Disc discOf(const std::array<Vec3, 3>& corners_W) noexcept;

/// The leaf that holds `count` triangles from `first` on, all of them in the box.
[[nodiscard]] Leaf makeLeaf(const Box& box, std::uint32_t first, std::uint32_t count) noexcept;

/// Sets the discs of a leaf from its faces; data.discs has its size already.
void layDiscs(SurfaceData& data, std::size_t leafIndex) noexcept;

/// Sets the ball around a face with these corners at another position of its path.
void layBall(BallQuad& quad, int lane, const Leaf& leaf, const std::array<Vec3, 3>& corners_W) noexcept;

/// Sets the boxes of all nodes from those of the leaves. Returns the box around all of them. `to`: one for each node of
/// the tree, or the nodes themselves.
Box layBoxes(const std::vector<TreeNode>& nodes, const std::vector<Box>& leafBoxes, std::vector<TreeNode>& to) noexcept;
Box layBoxes(
  const std::vector<TreeNode>& nodes, const std::vector<Box>& leafBoxes, std::vector<NodeBoxes>& to) noexcept;

/// Hash of the triangles in the order of the leaves: the same for two surfaces whose features have the same numbers.
[[nodiscard]] std::uint64_t hashTopology(const TriangleMesh& mesh) noexcept;

/// Hash of vertices, triangles and coat; uses the hash of the topology.
[[nodiscard]] std::uint64_t hashContent(const SurfaceData& data) noexcept;

} // namespace palpate
