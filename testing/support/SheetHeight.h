// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/core/Types.h"
#include "haptics/geometry/mesh/TriangleMesh.h"

namespace palpate::test
{

/// From a place to the nearest one of a mesh [u], every triangle looked at.
[[nodiscard]] double distanceTo(const TriangleMesh& mesh, const Vec3& x);

/// Height at the x and y of a place of a mesh that is one over the plane z = 0; NaN beside it.
[[nodiscard]] double heightAt(const TriangleMesh& mesh, const Vec3& x);

} // namespace palpate::test
