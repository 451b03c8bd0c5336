// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "haptics/geometry/mesh/TriangleMesh.h"
#include "haptics/geometry/tree/BoxTree.h"

namespace palpate
{

/// Bits of FaceRecord::owned: the edges and vertices that a face owns, so that a sweep over the
/// leaves tests each edge and each vertex once. Edge k joins corners k and (k + 1) % 3.
inline constexpr std::uint32_t ownsEdge0 = 1u;
inline constexpr std::uint32_t ownsVertex0 = 8u;

/// Data of a face besides its corners, in the order of the leaves. The corners are the mesh's own: a second copy
/// of them would be two thirds of the memory of a face.
struct FacePlane
{
  Vec3 normal_W; ///< unit, right-handed for the stored corners
  float sliver;  ///< how much the normal's rounding is amplified: |e||f| / |e x f| of two edges, 1 where it is exact
  std::uint32_t owned;
};

/// A face as the sweep reads it: with its corners.
struct FaceRecord : FacePlane
{
  std::array<Vec3, 3> corner_W;
};

/// Four faces' bounding discs in single precision relative to Leaf::origin_W, in the leaf's own unit, rounded outward:
/// the prefilter.
struct alignas(16) DiscQuad
{
  std::array<float, 4> cx, cy, cz, nx, ny, nz;
  std::array<float, 4> radius;
};

/// Balls around four faces at another position of their path, in the unit of their leaf.
struct alignas(16) BallQuad
{
  std::array<float, 4> cx, cy, cz;
  std::array<float, 4> radius;
};

/// Bounds of a surface at another point of its path: boxes for each node of the tree, balls for each quad of discs.
struct PlaceBounds
{
  std::vector<NodeBoxes> nodes;
  std::vector<BallQuad> balls;
  Box all;
};

/// At most eight consecutive faces, and the origin of their discs.
struct Leaf
{
  static constexpr std::uint32_t capacity = 8;
  Vec3 origin_W;
  double
    perUnit; ///< 1 u in the unit of its discs, in which no coordinate of its faces is further from the origin than 1
  std::uint32_t first;
  std::uint32_t count;
};

/// A segment of a curve stands among triangles as (a, b, b): an edge and two vertices without a face.
[[nodiscard]] inline bool isSegment(const std::array<std::uint32_t, 3>& corners) noexcept
{
  return corners[1] == corners[2];
}

/// The edge of a triangle that joins i and j: edge k joins corners k and (k + 1) % 3.
[[nodiscard]] inline std::size_t edgeOf(
  const std::array<std::uint32_t, 3>& corners, std::uint32_t i, std::uint32_t j) noexcept
{
  const auto isEnd = [&](std::uint32_t corner) { return corner == i || corner == j; };
  return isEnd(corners[0]) ? (isEnd(corners[1]) ? 0 : 2) : 1;
}

/// True if the stored corners run from i to j along their edge: two faces of an oriented surface run along their common
/// edge in opposite directions.
[[nodiscard]] inline bool runsAlong(
  const std::array<std::uint32_t, 3>& corners, std::uint32_t i, std::uint32_t j) noexcept
{
  return (corners[0] == i && corners[1] == j) || (corners[1] == i && corners[2] == j) ||
         (corners[2] == i && corners[0] == j);
}

/// All data that contact reads of one surface. Triangles stand in the order of the tree's leaves, corners ascending.
struct SurfaceData
{
  TriangleMesh mesh;
  double coat_u = 0.0; ///< above 0 for curves, which are segments: distance of the touched surface from them
  std::vector<FacePlane> faces;
  std::vector<DiscQuad> discs; ///< two per leaf
  std::vector<Leaf> leaves;
  std::vector<TreeNode> nodes;     ///< empty when there is a single leaf
  std::vector<PlaceBounds> places; ///< bounds at other positions of a path; nodes and discs are those of `mesh`
  Vec3 low_W = Vec3::Zero();
  Vec3 high_W = Vec3::Zero();
  std::vector<std::uint32_t> fanStart; ///< triangles around vertex v: fan[fanStart[v] .. fanStart[v + 1])
  std::vector<std::uint32_t> fan;
  /// The only other triangle over edge k of each triangle, or `none` where there is no other or more than one.
  std::vector<std::array<std::uint32_t, 3>> across;
  std::uint64_t contentHash = 0;
  std::uint64_t topologyHash = 0;
  std::uint64_t wayName = 0; ///< of `places`; 0: there are none

  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  [[nodiscard]] const Vec3& vertex(std::uint32_t v) const noexcept { return this->mesh.vertices_W[v]; }

  [[nodiscard]] const FacePlane& plane(std::uint32_t triangle) const noexcept { return this->faces[triangle]; }
  [[nodiscard]] std::array<Vec3, 3> cornersOf(std::uint32_t triangle) const noexcept
  {
    const auto& [a, b, c] = this->mesh.triangles[triangle];
    return { this->vertex(a), this->vertex(b), this->vertex(c) };
  }
  [[nodiscard]] FaceRecord face(std::uint32_t triangle) const noexcept
  {
    return { this->faces[triangle], this->cornersOf(triangle) };
  }
  [[nodiscard]] const std::array<std::uint32_t, 3>& corners(std::uint32_t triangle) const noexcept
  {
    return this->mesh.triangles[triangle];
  }

  /// Calls visit(triangle) for each triangle of a leaf.
  template<class Visit>
  void forEachInLeaf(std::uint32_t leaf, Visit visit) const
  {
    for (std::uint32_t t = this->leaves[leaf].first; t < this->leaves[leaf].first + this->leaves[leaf].count; ++t)
    {
      visit(t);
    }
  }

  /// Calls visit(triangle) for each triangle around vertex v.
  template<class Visit>
  void forEachAround(std::uint32_t v, Visit visit) const
  {
    for (std::uint32_t k = this->fanStart[v]; k < this->fanStart[v + 1]; ++k)
    {
      visit(this->fan[k]);
    }
  }

  [[nodiscard]] bool hasCorner(std::uint32_t triangle, std::uint32_t v) const noexcept
  {
    const auto& t = this->mesh.triangles[triangle];
    return t[0] == v || t[1] == v || t[2] == v;
  }

  /// The corner of `triangle` that is neither i nor j.
  [[nodiscard]] std::uint32_t opposite(std::uint32_t triangle, std::uint32_t i, std::uint32_t j) const noexcept
  {
    const auto& t = this->mesh.triangles[triangle];
    return t[0] != i && t[0] != j ? t[0] : (t[1] != i && t[1] != j ? t[1] : t[2]);
  }

  /// Number of triangles around vertex v.
  [[nodiscard]] std::uint32_t valence(std::uint32_t v) const noexcept
  {
    return this->fanStart[v + 1] - this->fanStart[v];
  }

  /// Calls visit(triangle) for each triangle around edge (i, j), in ascending order. The end with fewer triangles is
  /// searched: a spoke of a disc costs as little at the hub as at the rim.
  template<class Visit>
  void forEachAtEdge(std::uint32_t i, std::uint32_t j, Visit visit) const
  {
    if (this->valence(j) < this->valence(i))
    {
      std::swap(i, j);
    }
    for (std::uint32_t k = this->fanStart[i]; k < this->fanStart[i + 1]; ++k)
    {
      if (this->hasCorner(this->fan[k], j))
      {
        visit(this->fan[k]);
      }
    }
  }

  /// The only other triangle across edge (i, j), or `none` where there is no other or more than one.
  [[nodiscard]] std::uint32_t neighbour(std::uint32_t triangle, std::uint32_t i, std::uint32_t j) const noexcept
  {
    return this->across[triangle][edgeOf(this->mesh.triangles[triangle], i, j)];
  }
};

} // namespace palpate
