// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "haptics/geometry/mesh/TriangleMesh.h"
#include "testing/support/Random.h"

namespace palpate::test
{

/// A concave corner of planes n_i . x >= 0 through the origin (row 11). Lengths in metres.
struct Corner
{
  std::string name;
  std::vector<Vec3> normals; ///< unit, towards the free side
  Vec3 p_W;                  ///< device point
  Vec3 x_W;                  ///< where the proxy must rest
  double force_N;            ///< magnitude at 1000 N/m

  /// A point well inside the free cone.
  [[nodiscard]] Vec3 start_W() const;
};

/// The nine scenes S1 to S9: floor, corners, wedge, troughs, duplicated floor, skew trihedral, six-plane pit.
[[nodiscard]] std::vector<Corner> corners();

/// The planes of a corner as tessellated squares of 40 mm: they cross each other outside the free cone.
[[nodiscard]] TriangleMesh meshOf(const Corner& corner, Random& random);

} // namespace palpate::test
