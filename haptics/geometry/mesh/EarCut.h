// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/geometry/mesh/PlanarPolygon.h"

namespace palpate
{

/// Cuts corner by corner off a polygon: one whose triangle runs round as the polygon does, as seen, and holds no other
/// corner; where there is none, the one with the shortest edge behind it. Each cut leaves fewer corners, so the cuts
/// end, and all triangles together have the polygon's edges as their border. They may cover each other and the outside.
/// Corners are looked at up to a bound; a polygon too large for that is cut in the order of its corners.
void cutEars(const PlanarPolygon& polygon, const TakeTriangle& take);

} // namespace palpate
