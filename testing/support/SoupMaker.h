// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/geometry/mesh/TriangleMesh.h"
#include "testing/support/Random.h"

namespace palpate::test
{

/// A bad mesh and the clean, closed one it was made from.
struct BadMesh
{
  TriangleMesh clean; ///< watertight, triangles right-handed outwards
  TriangleMesh bad;
  double size_u = 1.0; ///< largest extent of the clean shape
  double edge_u = 1.0; ///< mean edge of the clean shape
  double gap_u = 0.0;  ///< no point of the clean shape is further than half of it from the bad one: a ball of a greater
                       ///< diameter cannot have its centre on the clean shape
  bool watertight = true;   ///< no way through for a point
  bool sameSurface = false; ///< only copies, flips, triangles without area and NaN: nothing that can be felt
};

/// A closed torus round the z axis: 2 * around * across triangles.
[[nodiscard]] TriangleMesh makeTorus(double bigRadius_u, double smallRadius_u, int around, int across);

/// A closed box [-1, 1]^3 whose sides have cells x cells squares of two triangles each.
[[nodiscard]] TriangleMesh makeCellBox(int cells);

/// Every triangle with corners of its own, each moved by `by_u` towards its middle (at most half of the distance):
/// cracks along all edges, no point of the old surface further than `by_u` from the new one.
[[nodiscard]] TriangleMesh shrunk(const TriangleMesh& mesh, double by_u);

/// A random closed shape (sphere, rough sphere, torus, box), stretched, turned and scaled by 1e-3 to 1e3, and a copy
/// with a random choice of slivers, T-junctions, cracks, holes, fins, triangles that cross it, duplicates and flips.
[[nodiscard]] BadMesh makeBadMesh(Random& random);

/// The same with nothing but duplicates, flips, triangles without area and NaN.
[[nodiscard]] BadMesh makeHarmlessBadMesh(Random& random);

} // namespace palpate::test
