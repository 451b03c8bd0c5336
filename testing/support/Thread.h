// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/core/Types.h"
#include "haptics/geometry/mesh/TriangleMesh.h"

namespace palpate::test
{

/// A thread about the z axis, its middle at z = 0: flanks of 45 degrees, half a pitch high.
struct ThreadSize
{
  double radius_u = 5.0; ///< at its root
  double pitch_u = 2.0;
  double length_u = 10.0;
};

/// Its surface as a sheet: strips along the helices of crest and root, so that both are edges.
[[nodiscard]] TriangleMesh threadMesh(const ThreadSize& size, int around);

/// To the surface of a screw, which is inside of the thread, and of a nut, which is outside of it; of the true flanks.
[[nodiscard]] double distanceToScrew(const ThreadSize& size, const Vec3& p);
[[nodiscard]] double distanceToNut(const ThreadSize& size, const Vec3& p);

} // namespace palpate::test
