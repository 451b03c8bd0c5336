// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/tool/mesh/BoxedMesh.h"

namespace palpate
{

/// A lower bound of the distance of what two boxes hold [u], negative or zero where nothing is proven: the best of the
/// boxes' six face normals and the line between their centres.
[[nodiscard]] double boxGap(const OrientedBox& a, const OrientedBox& b) noexcept;

/// A box of the body frame where the tool stands. `turn` is the pose's.
[[nodiscard]] OrientedBox posed(const OrientedBox& box_B, const Mat3& turn, const Vec3& centre_W) noexcept;

} // namespace palpate
