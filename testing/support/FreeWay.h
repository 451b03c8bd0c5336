// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "testing/support/TriangleGrid.h"

namespace palpate::test
{

/// True if the closed segment meets no triangle, in exact arithmetic; touching is meeting.
[[nodiscard]] bool wayIsFree(const TriangleGrid& grid, const Vec3& from_W, const Vec3& to_W);

/// True if a ball may be moved along the segment and comes nowhere nearer than it is allowed to: to no triangle nearer
/// than 1e-9 less than its radius, or than 1e-9 less than it was at the start where that is nearer. Exact.
[[nodiscard]] bool wayIsFree(const TriangleGrid& grid, const Vec3& from_W, const Vec3& to_W, double radius_u);

} // namespace palpate::test
