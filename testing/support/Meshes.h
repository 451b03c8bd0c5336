// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "haptics/geometry/mesh/TriangleMesh.h"
#include "haptics/geometry/scene/Scene.h"
#include "testing/support/Random.h"

namespace palpate::test
{

/// Axis-aligned closed box, 12 triangles.
[[nodiscard]] TriangleMesh makeBox(const Vec3& low_W, const Vec3& high_W);

/// Inscribed sphere: an icosahedron whose triangles are divided in four `levels` times, every vertex on the sphere.
/// 20 * 4^levels triangles.
[[nodiscard]] TriangleMesh makeIcosphere(int levels, double radius_u);

/// How a rectangle in the plane z = 0 around the origin is cut into triangles.
struct Tessellation
{
  double width_u = 1.0;  ///< along x
  double height_u = 1.0; ///< along y
  int columns = 1;
  int rows = 1;
  double jitter = 0.0; ///< 0 .. 0.4: how far an inner vertex moves, in cells
};

/// A rectangle with random diagonals and jittered vertices: 2 * columns * rows triangles, all with z == 0.
[[nodiscard]] TriangleMesh makeSheet(const Tessellation& how, Random& random);

/// A square tessellated plane through the origin with the given unit normal.
[[nodiscard]] TriangleMesh makePlane(const Vec3& normal, double half_u, int cells, Random& random);

/// Two walls that meet in the y axis, open upwards (+z); `halfAngle_rad` between each wall and the plane x = 0.
[[nodiscard]] TriangleMesh makeGroove(double halfAngle_rad, double size_u);

/// Two tessellated half planes z = 0, 40 mm in each direction, with a gap of `gap_m` between them along the y axis;
/// their vertices do not match.
[[nodiscard]] TriangleMesh makeCracked(double gap_m, Random& random);

/// A plate of height 1 stands on an inner edge (x = 0) of a floor of 2 by 2: its foot has three triangles.
[[nodiscard]] TriangleMesh makeFin();

/// Random triangles in the cube [-half, half]^3; every third is a sliver.
[[nodiscard]] TriangleMesh makeSoup(std::size_t count, double half_u, Random& random);

[[nodiscard]] TriangleMesh scaled(const TriangleMesh& mesh, double factor);
/// Each triangle has vertices of its own, as in an STL file or as views give it.
[[nodiscard]] TriangleMesh unwelded(const TriangleMesh& mesh);
[[nodiscard]] TriangleMesh shifted(const TriangleMesh& mesh, const Vec3& by_W);
[[nodiscard]] TriangleMesh rotated(const TriangleMesh& mesh, const Quat& q);

/// The same surface: vertices renumbered, triangles reordered, corners turned and flipped at random.
[[nodiscard]] TriangleMesh shuffled(const TriangleMesh& mesh, Random& random);

/// The same surface with five copies of some triangles, flipped copies, triangles without area and NaN ones.
[[nodiscard]] TriangleMesh withDefects(const TriangleMesh& mesh, Random& random);

/// Builds a scene of one surface; throws std::runtime_error with the reason if the mesh is refused.
[[nodiscard]] std::shared_ptr<const Scene> sceneOf(const TriangleMesh& mesh);

} // namespace palpate::test
