// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "haptics/core/Outcome.h"
#include "haptics/geometry/tree/SurfaceTree.h"

namespace palpate
{

/// A surface that knows its outer side: a tree's own triangles are stored in an order that says nothing of it.
/// Immutable.
struct SidedSurface
{
  static constexpr std::size_t mostTriangles = 20000; ///< of a body that moves: a finder looks at all of them
  static constexpr std::size_t mostStanding = 300000; ///< of one that stands: the numbers of its edges have 19 bits
  /// Of the diagonal of a loose body: so near to another one, or so deep in it, its contacts are found though neither
  /// moved. A body that begins deeper in another one is not pushed out.
  static constexpr double looseReach = 0.05;
  static constexpr double sharpBelow = 0.966; ///< cosine between the normals of an edge's triangles: 15 degrees

  /// An edge of two triangles.
  struct Edge
  {
    std::array<std::uint32_t, 2> ends{};
    std::array<std::uint32_t, 2> triangles{};
  };

  std::shared_ptr<const SurfaceTree> tree;
  std::vector<double> side; ///< of each triangle: 1 where its stored corners are right-handed about the outer normal
  std::vector<Edge> edges;  ///< each once
  std::vector<std::uint32_t> sharp; ///< numbers of the edges that are: along the others vertices are near enough
  double radius_u = 0.0;            ///< no vertex is further from the origin of its frame
  double diagonal_u = 0.0;          ///< of its bounds

  /// Outer normal of a triangle, its length twice the area, where the vertices are.
  [[nodiscard]] Vec3 areaOf(std::uint32_t triangle, const std::vector<Vec3>& vertices) const
  {
    const auto& [a, b, c] = this->tree->mesh().triangles[triangle];
    return this->side[triangle] * (vertices[b] - vertices[a]).cross(vertices[c] - vertices[a]);
  }
  /// The triangles with their corners right-handed about the outer normal.
  [[nodiscard]] TriangleMesh rightHanded() const;
  /// Of a vertex, unit: the mean over its triangles by area.
  [[nodiscard]] Vec3 normalAt(std::uint32_t vertex, const std::vector<Vec3>& vertices) const;
};

/// Triangles that are joined over edges have one side; the outer one is where the volume of each such piece is
/// positive. Meant for closed surfaces. Not real-time safe.
[[nodiscard]] std::shared_ptr<const SidedSurface> makeSided(std::shared_ptr<const SurfaceTree> tree);

/// Of the mesh of a rigid body, in the frame of the body. Refuses, in one sentence without an end, no mesh, an open
/// one, one in which an edge has more than two triangles, and one of too many triangles. Not real-time safe.
[[nodiscard]] Outcome<std::shared_ptr<const SidedSurface>> makeRigidMesh(const TriangleMesh& raw);

/// Likewise of a body that stands, from a clean surface where it stands. Not real-time safe.
[[nodiscard]] Outcome<std::shared_ptr<const SidedSurface>> makeStandingMesh(std::shared_ptr<const SurfaceTree> tree);

} // namespace palpate
