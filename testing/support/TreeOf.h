// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/geometry/tree/SurfaceTree.h"

namespace palpate::test
{

/// Of the mesh as it is cleaned.
[[nodiscard]] inline SurfaceTree treeOf(const TriangleMesh& mesh)
{
  return SurfaceTree(cleanMesh(mesh).mesh);
}

} // namespace palpate::test
