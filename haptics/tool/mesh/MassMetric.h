// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/geometry/mesh/TriangleMesh.h"

namespace palpate
{

/// Weights of a mesh in the distance between two poses, for a mass of one.
struct MassMetric
{
  Vec3 centre_W = Vec3::Zero();
  double gyration_u =
    0.0;              ///< radius of gyration, the mean of the three axes: a turn by w costs as much as a way of w L
  bool solid = false; ///< by its volume; else by its area
};

/// A closed mesh whose triangles are all turned the same way counts as a solid of even density, anything else as a
/// sheet of even thickness: open and flat meshes have no volume to weigh. `raw` as it came, since its corners' order is
/// lost by cleaning; `clean` is the result of cleanMesh and has area.
[[nodiscard]] MassMetric massMetric(const TriangleMesh& raw, const CleanResult& clean);

/// The same about a point where a hand holds it, as a sheet: turns are about that point, and the lever is
/// sqrt(2/3 mean |p|^2) of all points of its triangles.
[[nodiscard]] MassMetric metricAbout(const TriangleMesh& clean, const Vec3& handle_W);

} // namespace palpate
