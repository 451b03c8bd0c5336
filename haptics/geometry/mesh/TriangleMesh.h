// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "haptics/core/Types.h"

namespace palpate
{

/// Indexed triangles in scene units. As it comes in: nothing about it is trusted.
struct TriangleMesh
{
  std::vector<Vec3> vertices_W;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Result of cleaning. Counts of triangles unless said otherwise.
struct CleanReport
{
  std::size_t trianglesIn = 0;
  std::size_t trianglesOut = 0;
  std::size_t verticesOut = 0;
  std::size_t nonFinite = 0;        ///< dropped: a corner is NaN or infinite
  std::size_t collinear = 0;        ///< dropped: exactly collinear (exact predicate), repeated corner included
  std::size_t duplicate = 0;        ///< dropped: the same three corners again, in any order
  std::size_t boundaryEdges = 0;    ///< edges of one triangle (kept)
  std::size_t nonManifoldEdges = 0; ///< edges of three or more triangles (kept)
  bool segments = false;            ///< of curves: "triangles" are segments, "collinear" those without length

  /// "kept 78 604 of 78 610 triangles; dropped 6 (...)": one line for a person.
  [[nodiscard]] std::string summary() const;
};

/// A clean mesh, or the reason why none is left.
struct CleanResult
{
  TriangleMesh mesh;
  CleanReport report;
  std::string refusal;                     ///< empty when the mesh can be touched
  std::vector<std::uint32_t> sourceVertex; ///< for each vertex of `mesh` one of the raw mesh, the first of equal ones

  [[nodiscard]] bool ok() const noexcept { return refusal.empty(); }
};

/// Adds vertices and triangles of another mesh, welding nothing.
void append(TriangleMesh& mesh, const TriangleMesh& more);

/// Brings a mesh into the one form all contact is computed from: exactly equal vertices are
/// welded, vertices ordered by (x, y, z), corners ordered within each triangle, triangles ordered and unique,
/// exactly collinear ones dropped. The result does not depend on the order of the input.
/// Refuses (never throws for bad data): an index out of range, no triangle left.
/// `threads`: from 2 on the work is shared by two, with the same result.
[[nodiscard]] CleanResult cleanMesh(const TriangleMesh& raw, unsigned threads = 1);

/// The same for curves, whose segments stand in the mesh as triangles (a, b, b): PolyLines.h makes them. Welded and
/// ordered alike; segments without length and repeats are dropped. Refuses a triangle that is no segment.
[[nodiscard]] CleanResult cleanSegments(const TriangleMesh& raw, unsigned threads = 1);

/// Why a mesh cannot be touched as it is, without cleaning; empty when it can: a corner that is no finite vertex,
/// corners out of order, a triangle without area or a segment without length, nothing at all.
[[nodiscard]] std::string refuseUnclean(const TriangleMesh& mesh, bool segments);

} // namespace palpate
