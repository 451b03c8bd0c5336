// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/geometry/mesh/TriangleMesh.h"
#include "testing/support/Random.h"

namespace palpate::test
{

/// A displacement of one tick through a target. Lengths in metres.
struct Shot
{
  Vec3 from_W, to_W;
};

/// A flat sheet, or the same with bumps of 1 mm. 60 mm square, cells of 2.5 mm.
[[nodiscard]] TriangleMesh makeTarget(bool bumpy, Random& random);

/// Up to 10 mm in one tick of 1 ms, through a vertex, an edge or a face, from either side, beginning at least
/// `clearance_m` away from the plane of the sheet; a third of them straight down.
[[nodiscard]] Shot makeShot(const TriangleMesh& target, double clearance_m, Random& random);

} // namespace palpate::test
