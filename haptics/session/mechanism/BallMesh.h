// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/geometry/mesh/TriangleMesh.h"

namespace palpate
{

/// The ball of a hand as a mesh: an octahedron whose triangles are divided in four four times, all vertices on the
/// sphere about the origin. A plane across an axis meets a vertex, elsewhere the facets are below the sphere by at most
/// a 250th of the radius.
[[nodiscard]] TriangleMesh ballMesh(double radius_u);

} // namespace palpate
