// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/geometry/mesh/TriangleMesh.h"

namespace palpate
{

/// The mass metric of a mesh for the distance between two poses, for a mass of one.
struct MassMetric
{
  Vec3 centre_W = Vec3::Zero();
  double gyration_u =
    0.0;              ///< radius of gyration L, the mean of three axes: a rotation by w weighs as a displacement w L
  bool solid = false; ///< mass by volume; else by area
};

/// A closed mesh whose triangles are oriented consistently counts as a solid of uniform density, any other mesh as a
/// sheet of uniform thickness: open and flat meshes have no volume. `raw`: the mesh as given, since cleaning loses the
/// order of its corners; `clean` is the result of cleanMesh and has area.
[[nodiscard]] MassMetric massMetric(const TriangleMesh& raw, const CleanResult& clean);

/// The same about the point at which a hand holds the tool, as a sheet: rotations are about that point, and the lever
/// arm is sqrt(2/3 mean |p|^2) over all points of its triangles.
[[nodiscard]] MassMetric metricAbout(const TriangleMesh& clean, const Vec3& handle_W);

} // namespace palpate
