// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "haptics/geometry/mesh/TriangleMesh.h"

namespace palpate::lab
{

/// VTK's surface of triangles (flying edges, the triangles of marching cubes) where a function that is sampled on a
/// cube of points, one unit apart from 0 on, has that value.
using MeshContour = TriangleMesh (*)(int points, const std::function<double(const Vec3&)>& function, double level);

/// Null where this was built without VTK.
[[nodiscard]] MeshContour meshContour();

} // namespace palpate::lab
