// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "haptics/core/Types.h"
#include "haptics/geometry/mesh/TriangleMesh.h"

namespace palpate
{

/// A rim of a surface: edges of one triangle each that hang together.
struct SurfaceHole
{
  std::vector<std::uint32_t> vertices; ///< along it, numbered as in the mesh
  std::vector<std::array<std::uint32_t, 2>> edges;
  double length_u = 0.0;
  Vec3 centre_W = Vec3::Zero();
};

/// Triangles that hang together and are turned against the most of those around them, or, of a closed part that no
/// other encloses, all of them if they are turned inwards.
struct FlippedPart
{
  std::vector<std::uint32_t> triangles; ///< ascending
};

/// A triangle from whose middle it is not far straight in to the surface again.
struct ThinPlace
{
  std::uint32_t triangle = 0;
  double thickness_u = 0.0;
};

/// Faults of a surface that matter before its use. Numbers are those of the mesh as it came in.
struct SurfaceFaults
{
  std::vector<SurfaceHole> holes;   ///< the longest first
  std::vector<FlippedPart> flipped; ///< the largest first
  std::vector<ThinPlace> thin;      ///< the thinnest first; only looked for where there is no hole
};

/// Finds them; equal places count as one, triangles that repeat a place are passed over. A surface may be one-sided:
/// contradictions are counted for one side or the other. Walls below `thin_u` are thin; 0: none is looked
/// for. O(n log n). Refuses nothing: a mesh that cannot be touched has no faults to name.
[[nodiscard]] SurfaceFaults findFaults(const TriangleMesh& mesh, double thin_u);

} // namespace palpate
