// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/geometry/mesh/TriangleMesh.h"

namespace palpate::test
{

/// The regular icosahedron with its 12 vertices on the unit sphere, triangles right-handed outwards.
[[nodiscard]] TriangleMesh icosahedron();

} // namespace palpate::test
