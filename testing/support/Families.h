// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "haptics/geometry/mesh/TriangleMesh.h"
#include "testing/support/Random.h"

namespace palpate::test
{

/// Surfaces of one kind on which contact is hard.
struct Family
{
  const char* name;
  TriangleMesh (*make)(Random&); ///< of about unit size, but for Scales; half of them turned and shifted anywhere
};

/// Crests of 0.01 to 120 degrees, cones and spikes, screw threads, fans of 3 to 10,000, sheets with T-junctions flat
/// and folded, slivers to an aspect of 1e16, lattices of whole numbers, the same with holes, fine spheres, triangles
/// that cross, and scales of 1e-30 to 1e30. PALPATE_TEST_TRIANGLES bounds the finest of them.
[[nodiscard]] const std::vector<Family>& families();

} // namespace palpate::test
