// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/geometry/mesh/TriangleMesh.h"

namespace palpate
{

/// The ball of a hand as a mesh: an octahedron whose triangles are divided in four four times, all vertices on the
/// sphere about the origin. A plane across an axis meets a vertex, elsewhere the facets are below the sphere by at most
/// a 250th of the radius.
[[nodiscard]] TriangleMesh ballMesh(double radius_u);

/// The lever of the hand's spring against the turn of such a ball [u]. A ball that is pressed rests on a vertex, an
/// inverted pendulum: a force F tips it over where F R is above the stiffness K L^2 of its turn. The force of a hand
/// that is d ahead is K d: with L = 50 R it stays upright up to d = 2500 R, with L = R no further than the radius.
[[nodiscard]] constexpr double ballLever_u(double radius_u) noexcept
{
  return 50.0 * radius_u;
}

} // namespace palpate
