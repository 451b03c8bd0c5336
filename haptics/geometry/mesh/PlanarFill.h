// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/geometry/mesh/PlanarPolygon.h"

namespace palpate
{

/// Fills the points that lie an odd number of times inside a polygon, as seen, by constrained Delaunay triangulation.
/// The border of all triangles together is the polygon's edges, those that it passes an even number of times left out.
/// Where a corner lies on an edge, the edge becomes its parts, and triangles without area, as seen, join it to them.
/// False, and nothing is taken: edges cross, corners hide each other, or all corners are on a line, as seen.
[[nodiscard]] bool fillPlanar(const PlanarPolygon& polygon, const TakeTriangle& take);

} // namespace palpate
