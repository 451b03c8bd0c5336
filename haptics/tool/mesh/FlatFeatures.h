// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "haptics/tool/mesh/BoxedMesh.h"

namespace palpate
{

/// Edges whose two faces are coplanar to within `flat_u` and not folded back, and vertices that have only such edges
/// or also two others in one line. Edges of one face, or of three and more, are never flat. In the order of the
/// triangles.
[[nodiscard]] std::vector<FlatFlags> flatFlags(const TriangleMesh& mesh, double flat_u);

} // namespace palpate
